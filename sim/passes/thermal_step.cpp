#include "sim/passes/thermal_step.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "sim/error.h"
#include "sim/passes/sediment_step.h"

namespace talus {
namespace {

constexpr int max_substeps = 10000;

double inverse_squares(const Grid& grid) {
    return 1 / (grid.dx * grid.dx) + 1 / (grid.dy * grid.dy);
}

}  // namespace

int thermal_substeps(const Grid& grid, const ThermalSettings& settings, double span_s) {
    if (settings.scheme != ThermalScheme::gradient) return 1;
    const double needed =
        std::ceil(settings.rate_m2_per_s * span_s * inverse_squares(grid) / (0.5 * (1 - settings.porosity)));
    if (needed > max_substeps)
        throw Error(fmt::format(
            "thermal.rate_m2_per_s = {} needs {:.0f} sub-steps a tick on cells of {} m, at most {} are "
            "run: lower it or time.tick_s",
            settings.rate_m2_per_s, needed, std::min(grid.dx, grid.dy), max_substeps));
    return std::max(1, static_cast<int>(needed));
}

ThermalStep thermal_step(const Grid& grid, const ThermalSettings& settings, double span_s, int substeps) {
    const double dt = span_s / substeps;
    ThermalStep step;
    const auto slope = [](double degrees) {
        return static_cast<float>(std::tan(degrees * std::numbers::pi / 180));
    };
    ThermalNumbers& numbers = step.numbers;
    numbers.repose_slope = slope(settings.repose_deg);
    numbers.wet_slope = slope(settings.wet_deg);
    numbers.bedrock_slope = slope(settings.bedrock_deg);
    numbers.thermal_bulking = bulking_of(settings.porosity);
    numbers.weathering_m = static_cast<float>(settings.weathering_m_per_s * dt);
    numbers.cell_m = glm::vec2(grid.dx, grid.dy);
    numbers.face_share =
        glm::vec2(settings.rate_m2_per_s * dt / grid.dx, settings.rate_m2_per_s * dt / grid.dy);
    step.masked = settings.masked;
    step.scheme = settings.scheme;
    return step;
}

double natural_thermal_rate(const Grid& grid, double span_s, double porosity) {
    return 0.4 * (1 - porosity) / (span_s * inverse_squares(grid));
}

}  // namespace talus
