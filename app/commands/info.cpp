#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/commands/commands.h"
#include "app/core/app_parameters.h"
#include "app/core/tiled_terrain.h"
#include "sim/io/tile_sidecar.h"
#include "sim/preset.h"
#include "sim/terrain/state_hash.h"

namespace talus::app {
namespace {

nlohmann::ordered_json to_json(const Value& value) {
    return std::visit([](const auto& v) { return nlohmann::ordered_json(v); }, value);
}

void add_place(const std::optional<Georeference>& georeference, nlohmann::ordered_json& about) {
    if (!georeference) return;
    about["geotransform"] = georeference->transform;
    about["crs"] = georeference->wkt;
}

void print_json(const nlohmann::ordered_json& about) {
    fmt::print("{}\n", about.dump(2, ' ', false, nlohmann::json::error_handler_t::replace));
}

void print_place(const std::optional<Georeference>& georeference) {
    if (!georeference || georeference->wkt.empty()) return;
    const std::string& wkt = georeference->wkt;
    const auto first = wkt.find('"');
    fmt::print("coordinate system {}\n",
               first == std::string::npos ? wkt : wkt.substr(first, wkt.find('"', first + 1) - first + 1));
}

void print_samples(const std::string& file, const std::string& kind, const Grid& grid) {
    fmt::print("{}: {}\n{} x {} samples, {:.6g} x {:.6g} m apart: {:.2f} x {:.2f} km\n", file, kind, grid.nx,
               grid.ny, grid.dx, grid.dy, grid.width_m() / 1000, grid.height_m() / 1000);
}

// Of a file with a single level.
std::string words_on_overviews(const io::TiledFile& file) {
    try {
        return needs_overviews(file) ? "no overviews: opening it makes them beside it"
                                     : "no overviews, and so small that it needs none";
    } catch (const Error& error) {
        return error.what();
    }
}

// Of a raster that is too large to be held as a whole. Its heights are told where they were measured before.
void tiled_info(const std::string& path, const io::ImportSettings& import, bool json) {
    const io::TiledFile file(path, import);
    const TileTree tree(file.grid(), tile_patches, file.levels(), file.level_places());
    const std::optional<std::vector<TileBounds>> bounds = io::read_tile_sidecar(file, tree);
    const Grid& grid = file.grid();
    nlohmann::ordered_json about = {{"file", path},  {"kind", file.kind()}, {"nx", grid.nx},
                                    {"ny", grid.ny}, {"dx", grid.dx},       {"dy", grid.dy}};
    about["levels"] = nlohmann::ordered_json::array();
    for (const glm::ivec2 level : file.levels()) about["levels"].push_back({level.x, level.y});
    if (bounds) {
        const glm::vec2 heights = heights_of(*bounds);
        about["height_min"] = heights.x;
        about["height_max"] = heights.y;
    }
    add_place(file.georeference(), about);
    about["notes"] = file.notes();
    if (json) return print_json(about);
    print_samples(path, file.kind(), grid);
    if (file.levels().size() == 1)
        fmt::print("{}\n", words_on_overviews(file));
    else
        fmt::print("{} levels, the coarsest {} x {} samples\n", file.levels().size(), file.levels().back().x,
                   file.levels().back().y);
    if (bounds)
        fmt::print("heights {:.2f} to {:.2f} m\n", about["height_min"].get<double>(),
                   about["height_max"].get<double>());
    else
        fmt::print("heights not measured yet, 'talus render' does it\n");
    print_place(file.georeference());
    for (const std::string& note : file.notes()) fmt::print("note: {}\n", note);
}

}  // namespace

void info(const std::string& file, const io::ImportSettings& import, bool json) {
    if (!import.window && io::is_larger_than_a_terrain(file)) return tiled_info(file, import, json);
    const io::Document document = open_document(file, import);
    const TerrainState& state = document.state;
    const std::vector<float> ground = state.ground();
    const auto [low, high] = std::minmax_element(ground.begin(), ground.end());
    nlohmann::ordered_json about;
    about["file"] = file;
    about["kind"] = document.kind;
    about["nx"] = state.grid.nx;
    about["ny"] = state.grid.ny;
    about["dx"] = state.grid.dx;
    about["dy"] = state.grid.dy;
    about["height_min"] = *low;
    about["height_max"] = *high;
    about["ticks"] = state.clock.ticks;
    about["simulated_s"] = state.clock.simulated_s;
    about["hash"] = fmt::format("{:016x}", state_hash(state));
    add_place(state.georeference, about);
    if (document.cut_out) about["cut_out_of"] = document.cut_out->path.string();
    about["notes"] = document.notes;
    if (json) return print_json(about);
    print_samples(file, document.kind, state.grid);
    fmt::print("heights {:.2f} to {:.2f} m\n", *low, *high);
    if (state.clock.ticks > 0)
        fmt::print("{} ticks, {:.6g} s simulated\n", state.clock.ticks, state.clock.simulated_s);
    print_place(state.georeference);
    if (document.cut_out) fmt::print("cut out of {}\n", document.cut_out->path.string());
    for (const std::string& note : document.notes) fmt::print("note: {}\n", note);
}

void list_presets(bool json) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const Preset& preset : built_in_presets()) {
        if (!json) fmt::print("{:<10} {}\n", preset.name, preset.description);
        list.push_back({{"name", preset.name}, {"title", preset.title}, {"description", preset.description}});
    }
    if (json) fmt::print("{}\n", list.dump(2));
}

void list_parameters(bool json) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const Parameter& p : all_parameters()) {
        nlohmann::ordered_json entry = {{"name", p.name}, {"default", to_json(p.preset)}};
        std::string range;
        if (!p.choices.empty()) {
            entry["choices"] = p.choices;
            for (const std::string& name : p.choices) range += (range.empty() ? "" : ", ") + name;
        } else if (!std::holds_alternative<bool>(p.preset)) {
            entry["low"] = p.low;
            entry["high"] = p.high;
            range = fmt::format("{} to {}", p.low, p.high);
        } else {
            range = "true, false";
        }
        entry["unit"] = p.unit;
        entry["help"] = p.help;
        if (!json)
            fmt::print("{} = {}{}{}\n    {} ({})\n", p.name, to_text(p.preset), p.unit.empty() ? "" : " ",
                       p.unit, p.help, range);
        list.push_back(entry);
    }
    if (json) fmt::print("{}\n", list.dump(2));
}

}  // namespace talus::app
