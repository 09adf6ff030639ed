#include "sim/terrain/section.h"

#include <fmt/format.h>

#include <cmath>

#include "sim/error.h"

namespace talus {
namespace {

// The nearest corner of the samples' cells along an axis: corner i lies before sample i. What lies on the
// outermost samples belongs to the map's edge.
int corner_at(double sample, int count) {
    constexpr double on = 1e-6;
    if (sample <= on) return 0;
    if (sample >= count - 1 - on) return count;
    return static_cast<int>(std::lround(sample + 0.5));
}

glm::ivec2 corner_at(const Grid& grid, glm::dvec2 place_m) {
    return {corner_at(grid.column_of(place_m.x), grid.nx), corner_at(grid.row_of(place_m.y), grid.ny)};
}

}  // namespace

void check_section(const Grid& grid, const Section& section) {
    for (const glm::dvec2 end : {section.from_m, section.to_m})
        if (!(end.x >= 0 && end.x <= grid.width_m() && end.y >= 0 && end.y <= grid.height_m()))
            throw Error(
                fmt::format("section's end at {},{} m lies off the map, it must lie within 0,0 and {},{} m",
                            end.x, end.y, grid.width_m(), grid.height_m()));
    if (corner_at(grid, section.from_m) == corner_at(grid, section.to_m))
        throw Error(
            fmt::format("section from {},{} to {},{} m has both ends at one corner between samples, they "
                        "must lie farther apart",
                        section.from_m.x, section.from_m.y, section.to_m.x, section.to_m.y));
}

std::vector<SectionFace> faces_of(const Grid& grid, const Section& section) {
    const glm::ivec2 from = corner_at(grid, section.from_m);
    const glm::ivec2 to = corner_at(grid, section.to_m);
    const glm::ivec2 steps = glm::abs(to - from);
    const glm::ivec2 way(to.x < from.x ? -1 : 1, to.y < from.y ? -1 : 1);
    std::vector<SectionFace> faces;
    faces.reserve(static_cast<std::size_t>(steps.x) + static_cast<std::size_t>(steps.y));
    glm::ivec2 done(0);
    while (done != steps) {
        // How far to the side of the line the corner would lie after a step along each axis; whole numbers,
        // so that ties are the same everywhere.
        const auto off = [&](glm::ivec2 after) {
            return std::abs(static_cast<long long>(after.x) * steps.y -
                            static_cast<long long>(after.y) * steps.x);
        };
        const bool along_x = done.y == steps.y || (done.x < steps.x && off(done + glm::ivec2(1, 0)) <=
                                                                           off(done + glm::ivec2(0, 1)));
        const glm::ivec2 corner = from + done * way;
        if (along_x) {
            // Eastwards the right side is south, and discharge between rows counts north.
            faces.push_back({{way.x > 0 ? corner.x : corner.x - 1, corner.y - 1}, true, -way.x});
            ++done.x;
        } else {
            // Southwards the right side is west.
            faces.push_back({{corner.x, way.y > 0 ? corner.y : corner.y - 1}, false, -way.y});
            ++done.y;
        }
    }
    return faces;
}

}  // namespace talus
