#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/commands/commands.h"
#include "app/core/app_parameters.h"
#include "sim/preset.h"
#include "sim/terrain/state_hash.h"

namespace talus::app {
namespace {

nlohmann::ordered_json to_json(const Value& value) {
    return std::visit([](const auto& v) { return nlohmann::ordered_json(v); }, value);
}

}  // namespace

void info(const std::string& file, const io::ImportSettings& import, bool json) {
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
    if (document.state.georeference) {
        about["geotransform"] = document.state.georeference->transform;
        about["crs"] = document.state.georeference->wkt;
    }
    about["notes"] = document.notes;
    if (json) {
        fmt::print("{}\n", about.dump(2, ' ', false, nlohmann::json::error_handler_t::replace));
        return;
    }
    fmt::print(
        "{}: {}\n{} x {} samples, {:.6g} x {:.6g} m apart: {:.2f} x {:.2f} km\nheights {:.2f} to {:.2f} m\n",
        file, document.kind, state.grid.nx, state.grid.ny, state.grid.dx, state.grid.dy,
        state.grid.width_m() / 1000, state.grid.height_m() / 1000, *low, *high);
    if (state.clock.ticks > 0)
        fmt::print("{} ticks, {:.6g} s simulated\n", state.clock.ticks, state.clock.simulated_s);
    if (document.state.georeference && !document.state.georeference->wkt.empty()) {
        const std::string& wkt = document.state.georeference->wkt;
        const auto first = wkt.find('"');
        fmt::print("coordinate system {}\n", first == std::string::npos
                                                 ? wkt
                                                 : wkt.substr(first, wkt.find('"', first + 1) - first + 1));
    }
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
