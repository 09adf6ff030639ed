#include "sim/passes/water_numbers.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "sim/passes/tick_series.h"
#include "sim/passes/water_schedule.h"

namespace talus {

WaterNumbers water_numbers(const Grid& grid, glm::ivec2 tiles, const WaterSettings& settings, double tick_s,
                           std::size_t springs, const std::vector<float>& series) {
    const bool periodic = std::any_of(settings.edges.begin(), settings.edges.end(),
                                      [](EdgeKind kind) { return kind == EdgeKind::periodic; });
    // Rain by a table may begin within the tick, where all rests.
    const bool rains_everywhere =
        settings.rain_m_per_s > 0 && (!settings.rain_masked || !settings.driven.rain_mm_per_h.empty());
    const auto kind_of = [&](Edge edge) {
        return static_cast<int>(settings.edges[static_cast<std::size_t>(edge)]);
    };
    WaterNumbers numbers;
    numbers.samples = {grid.nx, grid.ny};
    numbers.tiles = tiles;
    numbers.cell_m = glm::vec2(grid.dx, grid.dy);
    numbers.tick_s = static_cast<float>(tick_s);
    numbers.water_gravity = static_cast<float>(settings.gravity_m_per_s2);
    numbers.water_manning = static_cast<float>(settings.manning_s_per_m13);
    numbers.water_roughness = static_cast<float>(settings.gravity_m_per_s2 * settings.manning_s_per_m13 *
                                                 settings.manning_s_per_m13);
    numbers.water_eulers = settings.order == 1 ? 2 : 1;
    numbers.rain_is_mapped = has_rain_map(settings) ? 1 : 0;
    numbers.rain_masked = settings.rain_masked ? 1 : 0;
    numbers.evaporation_m_per_s = static_cast<float>(settings.evaporation_m_per_s);
    numbers.infiltration_m_per_s = static_cast<float>(settings.infiltration_m_per_s);
    numbers.loss_m_per_s = static_cast<float>(settings.infiltration_m_per_s + settings.evaporation_m_per_s);
    numbers.every_tile = !settings.skips_rest || periodic || rains_everywhere ? 1 : 0;
    numbers.spring_count = static_cast<int>(springs);
    numbers.edge_kind_north = kind_of(Edge::north);
    numbers.edge_kind_south = kind_of(Edge::south);
    numbers.edge_kind_west = kind_of(Edge::west);
    numbers.edge_kind_east = kind_of(Edge::east);
    const auto inflow = series.begin() + glsl::series_inflow * glsl::tick_series_points;
    numbers.inflow_tick_mean = static_cast<float>(
        std::accumulate(inflow, inflow + glsl::tick_series_steps, 0.0) / glsl::tick_series_steps);
    numbers.inflow_root_slope = static_cast<float>(std::sqrt(settings.inflow_slope));
    numbers.has_sea = settings.has_sea ? 1 : 0;
    numbers.level_moves = settings.driven.sea_level_m.empty() ? 0 : 1;
    return numbers;
}

}  // namespace talus
