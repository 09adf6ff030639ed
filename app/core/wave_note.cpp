#include "app/core/wave_note.h"

#include <fmt/format.h>

#include "sim/passes/water.h"

namespace talus::app {
namespace {

// Mean still depth of the wet samples along the edges of kind wave, m; 0 where there are none.
double depth_at_waves(const TerrainState& state, const Parameters& parameters) {
    const std::vector<float> ground = state.ground();
    const Grid& grid = state.grid;
    const double level = parameters.number("water.sea_level_m");
    double sum = 0;
    int wet = 0;
    const auto add = [&](int column, int row) {
        const double depth = level - ground[static_cast<std::size_t>(row) * grid.nx + column];
        if (depth <= 0) return;
        sum += depth;
        ++wet;
    };
    const auto is_wave = [&](const char* edge) {
        return parameters.choice(std::string("water.boundary.") + edge) == "wave";
    };
    for (int column = 0; column < grid.nx; ++column) {
        if (is_wave("north")) add(column, 0);
        if (is_wave("south")) add(column, grid.ny - 1);
    }
    for (int row = 0; row < grid.ny; ++row) {
        if (is_wave("west")) add(0, row);
        if (is_wave("east")) add(grid.nx - 1, row);
    }
    return wet > 0 ? sum / wet : 0;
}

}  // namespace

std::string wave_note(const TerrainState& state, const Parameters& parameters) {
    if (!parameters.toggle("water.on") || parameters.choice("water.wave") != "sine") return "";
    const double depth_m = depth_at_waves(state, parameters);
    if (depth_m <= 0) return "";
    const double period_s = parameters.number("water.wave_period_s");
    const double excess =
        shallow_speed_excess(depth_m, period_s, parameters.number("water.gravity_m_per_s2"));
    return fmt::format(
        "{}waves of {:.3g} s over {:.3g} m of water run at √(gd), {:.1f} % faster than in nature{}",
        excess > 0.05 ? "warning: " : "", period_s, depth_m, 100 * excess,
        excess > 0.05 ? ": a longer water.wave_period_s or shallower water is truer" : "");
}

}  // namespace talus::app
