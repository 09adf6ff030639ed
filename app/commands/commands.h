#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/core/outputs.h"
#include "app/core/recording.h"
#include "app/core/scene.h"
#include "sim/gpu/context.h"
#include "sim/io/put_back.h"
#include "sim/terrain/section.h"

namespace talus::app {

/// A number that follows a table.
struct TableOption {
    std::string file;
    Drive drive;
};

/// A painted number as a raster has it.
struct RasterOption {
    std::string number;
    std::string file;
};

struct RunOptions {
    gpu::ContextChoice gpu;
    SceneRequest scene;
    std::optional<std::int64_t> ticks;
    std::optional<double> time_s;
    std::vector<Spring> springs;        ///< placed before the first tick
    std::vector<TableOption> tables;    ///< followed from before the first tick
    std::vector<RasterOption> rasters;  ///< taken before the first tick
    std::vector<glm::dvec2> gauges;     ///< places (m) whose water is written every tick
    std::string gauge_table = "gauges.csv";
    std::vector<Section> sections;  ///< lines (m) whose discharge is written every tick
    std::string section_table = "sections.csv";
    Outputs outputs;
    RecordingOptions recording;  ///< but for files and picture: those of the outputs whose names number them
};
void run(const RunOptions& options);

struct ReplayOptions {
    gpu::ContextChoice gpu;
    std::string journal;
    std::optional<glm::ivec2> size;  ///< samples of the terrain it starts from; unless given, as recorded
    Outputs outputs;
};
void replay(const ReplayOptions& options);

struct RenderOptions {
    gpu::ContextChoice gpu;
    SceneRequest scene;
    glm::ivec2 size{1280, 720};
    std::optional<glm::dvec3> eye;
    std::optional<glm::dvec3> target;
    std::string camera;  ///< by its name in the document; empty: none
    std::string image;   ///< with keys or a turntable: of the first, numbered before the ending
    std::string keys;    ///< file of key cameras to fly along
    int turntable = 0;   ///< frames once around the terrain's middle
    int frames = 120;    ///< along the keys
    std::string depth;
    std::string report;
    bool json = false;
};
void render(const RenderOptions& options);

struct CompareOptions {
    gpu::ContextChoice gpu;
    SceneRequest scene;
    std::vector<std::string> methods;  ///< empty: all
    std::vector<double> tolerances_px{0, 0.5, 2};
    glm::ivec2 size{480, 270};
    std::string keys;  ///< file of key cameras; empty: the survey's twelve
    int frames = 24;   ///< along the keys
    double limit_px = 4;
    std::string report;
    bool json = false;
};
/// Measures methods against the double-precision reference (render/measure.h): error, steps and time.
void compare(const CompareOptions& options);

struct VerifyOptions {
    gpu::ContextChoice gpu;
    std::string json;               ///< a file for the findings; empty: none
    std::vector<std::string> only;  ///< names of claims; empty: all
};
/// Checks what Talus claims of its numbers on this device (app/claims). Throws talus::Error where one does
/// not hold, after all were checked.
void verify(const VerifyOptions& options);

struct ConvertOptions {
    std::string input;
    std::string output;
    io::ImportSettings import;
    std::optional<glm::dvec2> range_m;  ///< heights of 0 and 65535 in integer outputs
    std::string layer;
    std::string kind;  ///< one of export_kind_names(); empty: by the output's ending
    glm::ivec2 tiles{1};
    double mesh_error_m = 1;
    std::vector<std::string> maps;   ///< these instead, each in a file of its own
    std::optional<int> weight_bits;  ///< of maps; 0: values; unless given, 8 for an engine
};
void convert(const ConvertOptions& options);

struct TileOptions {
    std::string input;   ///< empty: generated
    std::string kind;    ///< of generated terrain
    glm::ivec2 size{0};  ///< its samples
    std::uint32_t seed = 1;
    double relief_m = 2000;
    std::string output;  ///< empty: no terrain is written
    std::string photo;   ///< empty: none is written
    std::string photo_output;
    io::ImportSettings import;
};
/// Writes a raster of any size as a tiled GeoTIFF with overviews (sim/io/tile_writer.h), and measures its
/// tiles; a photo likewise (sim/io/photo_writer.h).
void tile(const TileOptions& options);

struct PutBackOptions {
    std::string document;  ///< of a terrain that was cut out of a larger one
    io::PutBackSettings settings;
};
/// Puts its ground back into its place in the larger one, as a patch and a mosaic of both
/// (sim/io/put_back.h).
void put_back(const PutBackOptions& options);

void info(const std::string& file, const io::ImportSettings& import, bool json);
void list_presets(bool json);
void list_parameters(bool json);

}  // namespace talus::app
