#include "sim/passes/dab_numbers.h"

#include <cmath>
#include <string>

namespace talus {
namespace {

// Takes a field of an effect where there is a number of the effect's name and the field's: ramp_rise_m.
struct TakeField {
    TALUS_TWIN_NAMES(float)
    DabNumbers& numbers;
    std::string effect;
    template <typename Value, typename... Range>
    void operator()(const char* field, const Value& value, const Range&... /*its range or choices*/) const {
        const std::string name = effect + "_" + field;
#define NUMBER(type, member)                              \
    if constexpr (requires { static_cast<type>(value); }) \
        if (name == #member) numbers.member = static_cast<type>(value);
#include "maths/dab_numbers.glsl"
#undef NUMBER
    }
};

// How a stamp of so many samples lies on the terrain.
void lay_stamp(const StampDab& stamp, DabNumbers& numbers) {
    const double turn = glm::radians(stamp.turn_deg);
    const glm::dvec2 a_metre = glm::dvec2(numbers.stamp_samples - 1) / (2.0 * stamp.half_m);
    const double side = stamp.mirrored ? -1 : 1;
    numbers.stamp_columns = glm::dvec2(std::cos(turn), -std::sin(turn)) * a_metre.x * side;
    numbers.stamp_rows = glm::dvec2(std::sin(turn), std::cos(turn)) * a_metre.y;
}

}  // namespace

DabNumbers dab_numbers(const Grid& grid, const Dab& dab, glm::ivec2 stamp_samples) {
    const double column = grid.column_of(dab.x_m);
    const double row = grid.row_of(dab.y_m);
    DabNumbers numbers;
    numbers.cell_m = glm::vec2(grid.dx, grid.dy);
    numbers.dab_sample = glm::ivec2(std::floor(column), std::floor(row));
    numbers.dab_offset = glm::vec2(column - std::floor(column), row - std::floor(row));
    // Rows run southwards.
    numbers.dab_length_m = glm::vec2(dab.way_m().x, -dab.way_m().y);
    numbers.dab_radius_m = static_cast<float>(dab.radius_m);
    numbers.dab_falloff = static_cast<float>(dab.falloff);
    numbers.dab_curve = static_cast<int>(dab.curve);
    numbers.dab_masked = dab.masked ? 1 : 0;
    numbers.dab_amount_m = static_cast<float>(dab.amount_m);
    numbers.dab_blend = static_cast<float>(dab.blend);
    numbers.dab_target_m.x = static_cast<float>(dab.target_m);
    numbers.dab_target_m.y = static_cast<float>(dab.target_m - numbers.dab_target_m.x);
    numbers.dab_on_regolith = dab.material == Material::regolith ? 1 : 0;
    numbers.dab_takes = dab.as<LowerDab>() ? 1 : 0;
    numbers.stamp_samples = stamp_samples;
    visit_own(dab, TakeField{numbers, brush_mode_names()[dab.effect.index()]});
    if (const auto* stamp = dab.as<StampDab>()) lay_stamp(*stamp, numbers);
    if (const auto* path = dab.as<PathDab>()) numbers.path_points = static_cast<int>(path->points_m.size());
    return numbers;
}

std::vector<glm::vec4> path_line(const Dab& dab) {
    std::vector<glm::vec4> line;
    for (const glm::dvec3& point : dab.as<PathDab>()->points_m)
        line.emplace_back(point.x - dab.x_m, dab.y_m - point.y, point.z - dab.target_m, 0);
    return line;
}

}  // namespace talus
