#include "sim/io/export.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/error.h"
#include "sim/io/atomic_file.h"
#include "sim/io/endings.h"
#include "sim/io/heightmap_formats.h"
#include "sim/io/map_export.h"
#include "sim/io/mesh_formats.h"
#include "sim/terrain/layers.h"
#include "sim/terrain/reshape.h"

namespace talus::io {
namespace {

namespace fs = std::filesystem;

// The endings that a kind can have.
std::vector<std::string> endings_of(ExportKind kind) {
    switch (kind) {
        case ExportKind::mesh:
            return mesh_endings();
        case ExportKind::normal_map:
            return {".png"};
        case ExportKind::unreal:
            return {".png", ".r16"};
        case ExportKind::unity:
            return {".raw", ".r16"};
        case ExportKind::godot:
            return {".r16", ".exr"};
        default:
            return writable_endings();
    }
}

void check_settings(const ExportSettings& settings) {
    const std::vector<std::string> endings = endings_of(settings.kind);
    const std::string& kind = export_kind_names()[static_cast<std::size_t>(settings.kind)];
    if (std::find(endings.begin(), endings.end(), ending_of(settings.path)) == endings.end())
        throw Error(fmt::format("cannot write '{}' as {}: its ending must be one of {}",
                                settings.path.string(), kind, fmt::join(endings, ", ")));
    if (settings.tiles.x < 1 || settings.tiles.y < 1 || settings.tiles.x > 64 || settings.tiles.y > 64)
        throw Error(fmt::format("{} x {} tiles cannot be written, it must be 1 to 64 each way",
                                settings.tiles.x, settings.tiles.y));
    if (settings.range_m && !(settings.range_m->y > settings.range_m->x))
        throw Error("the range's first height must be the lower one");
}

// The path of a tile: before its ending, its column and row.
fs::path tile_path(const fs::path& path, glm::ivec2 tiles, int column, int row) {
    if (tiles == glm::ivec2(1)) return path;
    fs::path named = path;
    return named.replace_filename(
        fmt::format("{}_x{}_y{}{}", path.stem().string(), column, row, path.extension().string()));
}

// 16-bit integers, little byte first.
void write_integers(const fs::path& path, const Heightmap& heightmap, Range range, bool south_first) {
    Heightmap turned = heightmap;
    if (south_first)
        for (int y = 0; y < heightmap.grid.ny; ++y)
            std::copy_n(heightmap.heights.begin() + static_cast<std::ptrdiff_t>(y) * heightmap.grid.nx,
                        heightmap.grid.nx,
                        turned.heights.begin() +
                            static_cast<std::ptrdiff_t>(heightmap.grid.ny - 1 - y) * heightmap.grid.nx);
    const std::vector<std::uint16_t> values = quantise(turned, range);
    write_atomically(path, std::as_bytes(std::span(values)));
}

// A layer with samples as the engine takes them, in so many tiles.
Heightmap for_engine(const Document& document, const ExportSettings& settings) {
    const Grid& grid = document.state.grid;
    const glm::ivec2 samples = samples_for_engine(grid, settings.kind, settings.tiles);
    // Ground and level go as one surface, so that lakes stay level; other layers each in its way.
    const bool is_surface = settings.layer == "ground" || settings.layer == "level";
    const TerrainState taken = resampled(
        is_surface ? bedrock_terrain(grid, output_of(document.state, settings.layer)) : document.state,
        samples.x, samples.y);
    Heightmap heightmap;
    heightmap.grid = taken.grid;
    heightmap.heights = is_surface ? taken.ground() : output_of(taken, settings.layer);
    return heightmap;
}

void add_engine_values(ExportKind engine, const Heightmap& whole, Exported& exported) {
    const Grid& grid = whole.grid;
    const Range range = exported.range_m;
    const auto add = [&](const char* name, const std::string& value) {
        exported.values.emplace_back(name, value);
    };
    const auto metres = [](double m) { return fmt::format("{:.9g}", m); };
    const glm::dvec2 tile_m = glm::dvec2(exported.tile_samples - 1) * exported.spacing_m;
    if (engine == ExportKind::unreal) {
        // Landscape: a sample is (value - 32768) / 128 * Scale Z centimetres above Location Z.
        const double scale_z = (range.y - range.x) * 100 * 128 / 65535;
        const double location_z = (range.x * 100) + 32768 * scale_z / 128;
        add("Resolution", fmt::format("{} x {}", exported.tile_samples.x, exported.tile_samples.y));
        add("Scale X", metres(grid.dx * 100));
        add("Scale Y", metres(grid.dy * 100));
        add("Scale Z", metres(scale_z));
        add("Location Z", metres(location_z));
    } else if (engine == ExportKind::unity) {
        add("Depth", "Bit 16");
        add("Byte Order", "Windows");
        add("Resolution", fmt::format("{}", exported.tile_samples.x));
        add("Flip Vertically", "off");
        add("Terrain Width", metres(tile_m.x));
        add("Terrain Length", metres(tile_m.y));
        add("Terrain Height", metres(range.y - range.x));
        add("Position Y", metres(range.x));
    } else {
        add("r16_size", fmt::format("{}, {}", exported.tile_samples.x, exported.tile_samples.y));
        add("r16_range", fmt::format("{}, {}", metres(range.x), metres(range.y)));
        add("vertex_spacing", metres(grid.dx));
    }
}

}  // namespace

Heightmap piece_of(const Heightmap& whole, std::pair<int, int> columns, std::pair<int, int> rows) {
    Heightmap piece;
    piece.grid = {columns.second, rows.second, whole.grid.dx, whole.grid.dy};
    piece.heights.reserve(piece.grid.count());
    for (int y = 0; y < rows.second; ++y) {
        const auto from = whole.heights.begin() +
                          static_cast<std::ptrdiff_t>(rows.first + y) * whole.grid.nx + columns.first;
        piece.heights.insert(piece.heights.end(), from, from + columns.second);
    }
    if (whole.georeference) {
        piece.georeference = whole.georeference;
        std::array<double, 6>& t = piece.georeference->transform;
        t[0] += t[1] * columns.first + t[2] * rows.first;
        t[3] += t[4] * columns.first + t[5] * rows.first;
    }
    return piece;
}

const std::vector<std::string>& export_kind_names() {
    static const std::vector<std::string> names = {"heightmap", "mesh",  "normal map", "maps",
                                                   "unreal",    "unity", "godot"};
    return names;
}

bool is_engine(ExportKind kind) {
    return kind == ExportKind::unreal || kind == ExportKind::unity || kind == ExportKind::godot;
}

int engine_samples(ExportKind engine, int samples) {
    // Unreal: the sizes that its documentation recommends ("Landscape Technical Guide"); Unity: a power of
    // two and one more.
    std::vector<int> sizes;
    if (engine == ExportKind::unreal)
        sizes = {127, 253, 505, 1009, 2017, 4033, 8129};
    else if (engine == ExportKind::unity)
        for (int power = 32; power <= 4096; power *= 2) sizes.push_back(power + 1);
    else
        return samples;
    return *std::min_element(sizes.begin(), sizes.end(), [&](int a, int b) {
        return std::abs(std::log(static_cast<double>(a) / samples)) <
               std::abs(std::log(static_cast<double>(b) / samples));
    });
}

glm::ivec2 samples_for_engine(const Grid& grid, ExportKind engine, glm::ivec2 tiles) {
    // Godot's Terrain3D takes any size, and one spacing for both ways.
    if (engine == ExportKind::godot)
        return {grid.nx, static_cast<int>(std::lround(grid.height_m() / grid.dx)) + 1};
    const auto a_tile = [&](int count, int across) {
        const double samples = static_cast<double>(count - 1) / across + 1;
        return engine_samples(engine, static_cast<int>(std::lround(samples))) - 1;
    };
    glm::ivec2 tile(a_tile(grid.nx, tiles.x), a_tile(grid.ny, tiles.y));
    // Unity's tiles are square.
    if (engine == ExportKind::unity) tile = glm::ivec2(std::max(tile.x, tile.y));
    return tile * tiles + 1;
}

std::vector<std::pair<int, int>> split_samples(int samples, int tiles) {
    if (samples - 1 < tiles)
        throw Error(fmt::format("{} samples cannot be split into {} tiles of two or more", samples, tiles));
    std::vector<std::pair<int, int>> pieces;
    for (int i = 0; i < tiles; ++i) {
        const auto edge = [&](int k) { return static_cast<int>(std::int64_t{samples - 1} * k / tiles); };
        pieces.emplace_back(edge(i), edge(i + 1) - edge(i) + 1);
    }
    return pieces;
}

namespace {

Exported export_mesh(const Heightmap& whole, const ExportSettings& settings) {
    Exported exported;
    std::size_t triangles = 0;
    double sum_m = 0;
    double samples = 0;
    double farthest_m = 0;
    int row = 0;
    for (const auto& rows : split_samples(whole.grid.ny, settings.tiles.y)) {
        int column = 0;
        for (const auto& columns : split_samples(whole.grid.nx, settings.tiles.x)) {
            const TerrainMesh mesh = mesh_of_tile(whole, settings.mesh_error_m, columns, rows);
            const fs::path path = tile_path(settings.path, settings.tiles, column++, row);
            mesh_format_of(path)->write(path, mesh);
            exported.files.push_back(path);
            triangles += mesh.indices.size() / 3;
            sum_m += mesh.mean_m * columns.second * rows.second;
            samples += columns.second * rows.second;
            farthest_m = std::max(farthest_m, mesh.farthest_m);
        }
        ++row;
    }
    exported.values = {{"Triangles", fmt::format("{}", triangles)},
                       {"Mean error", fmt::format("{:.3g} m", sum_m / samples)},
                       {"Largest error", fmt::format("{:.3g} m", farthest_m)}};
    return exported;
}

}  // namespace

Exported export_terrain(const Document& document, const ExportSettings& settings) {
    if (settings.kind == ExportKind::maps) return export_maps(document.state, settings);
    check_settings(settings);
    Heightmap whole;
    if (is_engine(settings.kind)) {
        whole = for_engine(document, settings);
    } else {
        whole.grid = document.state.grid;
        whole.heights = output_of(document.state, settings.layer);
        whole.georeference = document.state.georeference;
    }
    Exported exported;
    if (settings.kind == ExportKind::mesh) return export_mesh(whole, settings);
    // One range for all tiles: they meet.
    exported.range_m = range_for(whole, settings.range_m);
    exported.spacing_m = {whole.grid.dx, whole.grid.dy};
    const auto columns = split_samples(whole.grid.nx, settings.tiles.x);
    const auto rows = split_samples(whole.grid.ny, settings.tiles.y);
    exported.tile_samples = {columns[0].second, rows[0].second};
    const bool south_first = settings.kind == ExportKind::unity;
    for (int row = 0; row < settings.tiles.y; ++row)
        for (int column = 0; column < settings.tiles.x; ++column) {
            const Heightmap piece = piece_of(whole, columns[static_cast<std::size_t>(column)],
                                             rows[static_cast<std::size_t>(row)]);
            // Unity counts tiles from the south too.
            const int named_row = south_first ? settings.tiles.y - 1 - row : row;
            const fs::path path = tile_path(settings.path, settings.tiles, column, named_row);
            const std::string ending = ending_of(path);
            if (settings.kind == ExportKind::normal_map)
                write_normal_map(path, whole, columns[static_cast<std::size_t>(column)],
                                 rows[static_cast<std::size_t>(row)]);
            else if (is_engine(settings.kind) && (ending == ".raw" || ending == ".r16"))
                write_integers(path, piece, exported.range_m, south_first);
            else
                write_heightmap(path, piece, exported.range_m);
            exported.files.push_back(path);
        }
    if (is_engine(settings.kind)) {
        add_engine_values(settings.kind, whole, exported);
        std::string text;
        for (const auto& [name, value] : exported.values) text += fmt::format("{}: {}\n", name, value);
        const fs::path notes = settings.path.string() + ".txt";
        write_atomically(notes, text);
        exported.files.push_back(notes);
    }
    return exported;
}

std::vector<std::string> losses(const TerrainState& state, const ExportSettings& settings) {
    std::vector<std::string> lost;
    const std::string ending = ending_of(settings.path);
    const bool is_of_maps = settings.kind == ExportKind::maps;
    const ExportKind engine = is_of_maps ? settings.samples_for : settings.kind;
    if (is_engine(engine)) {
        const glm::ivec2 samples = samples_for_engine(state.grid, engine, settings.tiles);
        if (samples != glm::ivec2(state.grid.nx, state.grid.ny))
            lost.push_back(fmt::format("{} x {} samples are resampled to sizes that it takes: {} x {}",
                                       state.grid.nx, state.grid.ny, samples.x, samples.y));
    }
    if (is_of_maps) {
        const HeightmapFormat* format = format_of(settings.path);
        if (settings.weight_bits > 0)
            lost.push_back(fmt::format("maps become shares of {} steps", (1 << settings.weight_bits) - 1));
        else if (format && format->rounds)
            lost.emplace_back("values are rounded to 16 bits, each map over its own range");
        return lost;
    }
    std::string layers;
    const auto layer = [&](bool there, const char* name) {
        if (there) layers += (layers.empty() ? "" : ", ") + std::string(name);
    };
    layer(std::any_of(state.regolith.begin(), state.regolith.end(), [](glm::vec2 r) { return r.x > 0; }),
          "which part of the ground is regolith");
    const std::vector<std::string> written = numbers_of_output(settings.layer);
    for (const LayerDescription& one : talus::layers())
        if (one.is_optional() && std::find(written.begin(), written.end(), one.name) == written.end())
            layer(!words_of(state, one).empty(), one.name.c_str());
    if (!layers.empty())
        lost.push_back(fmt::format("not written: {}; a Talus document (Save as) keeps all", layers));
    const std::vector<float> heights = output_of(state, settings.layer);
    const HeightmapFormat* format = format_of(settings.path);
    // Unity's .raw holds integers too.
    const bool integers = (format && format->rounds) || ending == ".raw";
    if (settings.kind == ExportKind::mesh || settings.kind == ExportKind::normal_map || !integers)
        return lost;
    Heightmap heightmap;
    heightmap.heights = heights;
    const Range range = range_for(heightmap, settings.range_m);
    const std::string unit = output_unit(settings.layer).empty() ? "" : " " + output_unit(settings.layer);
    lost.push_back(
        fmt::format("values are rounded to 16 bits, steps of {:.3g}{}", (range.y - range.x) / 65535, unit));
    const auto outside =
        std::count_if(heights.begin(), heights.end(), [&](float h) { return h < range.x || h > range.y; });
    if (outside > 0)
        lost.push_back(
            fmt::format("{} samples beyond {:.6g} to {:.6g}{} are cut off", outside, range.x, range.y, unit));
    return lost;
}

}  // namespace talus::io
