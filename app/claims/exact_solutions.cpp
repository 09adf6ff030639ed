#include "app/claims/exact_solutions.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sim/ledger.h"
#include "sim/passes/thermal.h"

namespace talus::claims {

using scenes::WaterRun;
using scenes::WaterScene;

namespace {

glm::dvec2 velocity_of(const glm::vec4& water) {
    const double h = water.x;
    const double factor = 2 * h / (h * h + std::max(h * h, 1e-12));
    return {factor * water.z, factor * water.w};
}

}  // namespace

double fastest_of(const TerrainState& state) {
    double fastest = 0;
    for (const glm::vec4& water : state.water) fastest = std::max(fastest, glm::length(velocity_of(water)));
    return fastest;
}

SceneError error_after(const WaterScene& scene) {
    WaterRun run(scene.state(), scene.settings);
    run.run(scene.tick_s, scene.end_s);
    return {depth_error(scene, run.read(), scene.end_s), run.water.work().substeps};
}

LakeMoved lake_at_rest(double datum_m, std::uint64_t substeps) {
    const WaterScene scene = scenes::lake(128, datum_m);
    const TerrainState start = scene.state();
    WaterRun run(start, scene.settings);
    run.settings.skips_rest = false;
    LakeMoved moved;
    while (run.water.work().substeps < substeps) {
        run.run(1, run.time_s() + 20);
        moved.fastest_m_per_s = std::max(moved.fastest_m_per_s, fastest_of(run.read()));
    }
    const TerrainState end = run.read();
    for (std::size_t i = 0; i < end.water.size(); ++i)
        moved.level_m =
            std::max(moved.level_m, std::abs(static_cast<double>(end.water[i].x) - start.water[i].x));
    moved.substeps = run.water.work().substeps;
    return moved;
}

WaveError small_wave_error(int waves_x, int waves_y) {
    constexpr int n = 80;
    constexpr double pi = std::numbers::pi;
    const WaterScene scene = scenes::small_wave(n, waves_x, waves_y);
    WaterRun run(scene.state(), scene.settings);
    run.run(scene.tick_s, scene.end_s);
    const TerrainState end = run.read();
    // The phase of the mode, against the exact one's.
    glm::dvec2 found(0);
    glm::dvec2 exact(0);
    for (int row = 0; row < n; ++row)
        for (int column = 0; column < n; ++column) {
            const double x = (column + 0.5) * scene.grid.dx;
            const double y = (n - 1 - row + 0.5) * scene.grid.dy;
            const double phase = 2 * pi * (waves_x * x + waves_y * y) / 640;
            const glm::dvec2 wave(std::cos(phase), std::sin(phase));
            found += wave * (end.water[static_cast<std::size_t>(row) * n + column].x - 7.0);
            exact += wave * (scene.water(x, y, scene.end_s).x - 7.0);
        }
    const double k = 2 * pi * std::hypot(waves_x, waves_y) / 640;
    const double behind = std::remainder(std::atan2(exact.y, exact.x) - std::atan2(found.y, found.x), 2 * pi);
    const double travelled = k * std::sqrt(9.81 * 7) * scene.end_s;
    return {-behind / travelled, glm::length(found) / glm::length(exact)};
}

ConeError collapsed_column(int n, double column_radius_m, double height_m, ThermalScheme scheme) {
    const int middle = n / 2;
    const Grid grid{n, n, 1, 1};
    const double slope = std::tan(33 * std::numbers::pi / 180);
    std::vector<float> heights(grid.count(), 0.0F);
    double volume = 0;
    for (int y = 0; y < n; ++y)
        for (int x = 0; x < n; ++x)
            if (std::hypot(x - middle, y - middle) <= column_radius_m) {
                heights[static_cast<std::size_t>(y) * n + x] = static_cast<float>(height_m);
                volume += height_m;
            }
    ConeError cone;
    // V = pi R^2 H / 3 with H = R S.
    const double radius = std::cbrt(3 * volume / (std::numbers::pi * slope));
    cone.exact_m = 0.75 * radius;
    cone.exact_peak_m = radius * slope;
    Terrain terrain(bedrock_terrain(grid, heights));
    Thermal thermal(terrain);
    Ledger ledger(terrain);
    const LedgerStart begin = ledger.begin(terrain, {});
    ThermalSettings settings{33, 0.25};
    settings.scheme = scheme;
    const ThermalStep step = thermal_step(grid, settings, 1, 1);
    cone.ticks = static_cast<int>(2 * radius * radius);
    for (int i = 0; i < cone.ticks; ++i) thermal.substep(terrain, step);

    const std::vector<float> ground = terrain.ground.read_all<float>();
    const auto at = [&](int x, int y) {
        return static_cast<double>(ground[static_cast<std::size_t>(y) * n + x]);
    };
    double steepest = 0;
    for (int y = 1; y < n - 1; ++y)
        for (int x = 1; x < n - 1; ++x)
            steepest = std::max(
                steepest, std::hypot((at(x + 1, y) - at(x - 1, y)) / 2, (at(x, y + 1) - at(x, y - 1)) / 2));
    // Along a direction, by linear interpolation.
    const auto contour = [&](int dx, int dy) {
        const double level = cone.exact_peak_m / 4;
        for (int i = 0; i + 1 < middle; ++i) {
            const double a = at(middle + i * dx, middle + i * dy);
            const double b = at(middle + (i + 1) * dx, middle + (i + 1) * dy);
            if (a >= level && b < level) return (i + (a - level) / (a - b)) * std::hypot(dx, dy);
        }
        return 0.0;
    };
    cone.axis_m = contour(1, 0);
    cone.diagonal_m = contour(1, 1);
    cone.steepest_deg = std::atan(steepest) * 180 / std::numbers::pi;
    cone.peak_m = at(middle, middle);
    ledger.sum(terrain);
    cone.ledger_of_moved =
        ledger.reading(begin, ledger.tile_sums().read_all<glm::dvec4>(), {}, {}).closing_error_of_moved();
    return cone;
}

}  // namespace talus::claims
