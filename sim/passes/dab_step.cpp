#include "sim/passes/dab_step.h"

#include <cmath>

namespace talus {

DabStep dab_step(const Grid& grid, const Dab& dab, glm::ivec2 stamp_samples) {
    const double column = grid.column_of(dab.x_m);
    const double row = grid.row_of(dab.y_m);
    DabStep step;
    step.cell_m = glm::vec2(grid.dx, grid.dy);
    step.sample = glm::ivec2(std::floor(column), std::floor(row));
    step.offset = glm::vec2(column - std::floor(column), row - std::floor(row));
    step.radius_m = static_cast<float>(dab.radius_m);
    step.falloff = static_cast<float>(dab.falloff);
    step.curve = static_cast<int>(dab.curve);
    // Rows run southwards.
    step.length_m = glm::vec2(dab.way_m().x, -dab.way_m().y);
    if (const auto* ramp = dab.as<RampDab>()) step.rise_m = static_cast<float>(ramp->rise_m);
    step.mode = static_cast<int>(dab.mode());
    step.amount_m = static_cast<float>(dab.amount_m);
    step.blend = static_cast<float>(dab.blend);
    step.target_m.x = static_cast<float>(dab.target_m);
    step.target_m.y = static_cast<float>(dab.target_m - step.target_m.x);
    step.on_regolith = dab.material == Material::regolith ? 1 : 0;
    if (const auto* stamp = dab.as<StampDab>()) {
        const double turn = glm::radians(stamp->turn_deg);
        const glm::dvec2 a_metre = glm::dvec2(stamp_samples - 1) / (2.0 * stamp->half_m);
        const double side = stamp->mirrored ? -1 : 1;
        step.stamp_columns = glm::dvec2(std::cos(turn), -std::sin(turn)) * a_metre.x * side;
        step.stamp_rows = glm::dvec2(std::sin(turn), std::cos(turn)) * a_metre.y;
        step.stamp_zero = static_cast<float>(stamp->zero);
    }
    return step;
}

}  // namespace talus
