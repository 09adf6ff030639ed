#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "sim/io/document.h"

namespace talus::io {

/// What other programs get of a terrain.
enum class ExportKind { heightmap, mesh, normal_map, maps, unreal, unity, godot };
const std::vector<std::string>& export_kind_names();
bool is_engine(ExportKind kind);

/// How it is written. The endings: heightmaps as write_heightmap takes them; .obj, .gltf and .glb for a mesh;
/// .png for a normal map; .png or .r16 for Unreal, .raw or .r16 for Unity, .r16 or .exr for Godot.
struct ExportSettings {
    ExportKind kind = ExportKind::heightmap;
    std::filesystem::path path;
    std::string layer = "ground";
    std::optional<Range>
        range_m;          ///< heights of the smallest and largest integer; unless given, lowest and highest
    glm::ivec2 tiles{1};  ///< columns and rows of tiles that share their edge samples; file names get _xC_yR
    double mesh_error_m = 1;  ///< a mesh: how far it may lie above or below a sample
    /// Maps, at least one: outputs by their names (sim/terrain/layers.h). Each is a file whose name has _MAP
    /// before its ending; a .json says what they hold.
    std::vector<std::string> maps;
    /// Of maps: 8 or 16: weights of so many bits in .png, which with one more, `rest`, sum to 255 or 65535 at
    /// every sample. 0: values.
    int weight_bits = 0;
    /// Of maps: as many samples as this takes; heightmap: as the terrain has.
    ExportKind samples_for = ExportKind::heightmap;
};

/// A file that an export leaves, and, for engines, what is to be typed there.
struct Exported {
    std::vector<std::filesystem::path> files;
    std::vector<std::pair<std::string, std::string>> values;  ///< name and value, as the engine calls them
    glm::ivec2 tile_samples{0};
    glm::dvec2 spacing_m{0};
    Range range_m{0};
};

/// Writes it. Throws talus::Error that names what cannot be written so.
Exported export_terrain(const Document& document, const ExportSettings& settings);

/// What gets lost on the way, a sentence each: layers, depth of heights, what lies beyond the range, samples
/// that are resampled.
std::vector<std::string> losses(const TerrainState& state, const ExportSettings& settings);

/// Columns (or rows) of samples that an engine takes nearest to this many, from its documentation.
int engine_samples(ExportKind engine, int samples);

/// Columns and rows of samples that an engine takes for such a terrain in so many tiles.
glm::ivec2 samples_for_engine(const Grid& grid, ExportKind engine, glm::ivec2 tiles = glm::ivec2(1));

/// First sample and number of samples of each of so many tiles along an axis of so many samples; neighbours
/// share one.
std::vector<std::pair<int, int>> split_samples(int samples, int tiles);

/// A mesh of triangles over the samples of a heightmap.
struct TerrainMesh {
    std::vector<glm::vec3> positions;  ///< metres: east, north, up from the south-west sample
    std::vector<unsigned> indices;     ///< counterclockwise from above
    std::vector<glm::vec3> normals;    ///< of the ground at each vertex; as the positions
    /// Of each vertex in a picture of a pixel a sample over the whole map: from its north-west corner east
    /// and south, 0 to 1.
    std::vector<glm::vec2> texture_places;
    double error_m = 0;  ///< as meshoptimizer counts it: a mean distance over what was merged
    double mean_m = 0;   ///< measured: how far samples lie above or below it on average, and at most
    double farthest_m = 0;
};
/// Simplified by meshoptimizer until no sample lies farther than `error_m` above or below it; the border
/// keeps its line.
TerrainMesh simplified_mesh(const Heightmap& heightmap, double error_m);
/// The same of a piece, by its first column and row and how many, in its place: metres, normals and texture
/// places are of the whole, and tiles meet, for their borders keep their lines.
TerrainMesh mesh_of_tile(const Heightmap& whole, double error_m, std::pair<int, int> columns,
                         std::pair<int, int> rows);
/// Those samples alone.
Heightmap piece_of(const Heightmap& whole, std::pair<int, int> columns, std::pair<int, int> rows);
/// The ground's unit normal (east, north, up) at a sample, by central differences; at edges one-sided ones.
glm::dvec3 ground_normal(const Heightmap& heightmap, int column, int row);

/// The ground's unit normals as a picture: red east, green north, blue up, each from -1 to 1 as 0 to 65535.
/// Of a piece: its first column and row and how many; slopes look beyond its edge, so that tiles meet.
void write_normal_map(const std::filesystem::path& path, const Heightmap& heightmap,
                      std::pair<int, int> columns, std::pair<int, int> rows);

}  // namespace talus::io
