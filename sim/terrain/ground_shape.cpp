#include "sim/terrain/ground_shape.h"

#include <algorithm>

#include "shaders/maths/twin.h"

namespace talus::maths {

// What masks are made of, on the CPU.
struct GroundShapeTwin {
    TALUS_TWIN_NAMES(float)

    const Grid& grid;
    const std::vector<float>& ground_m;
    real2 cell_m{1};
    int mask_source = 0;
    real mask_low = 0;
    real mask_high = 0;
    real mask_fade = 0;
    real4 mask_rectangle{0};

    real load_ground(int2 at) const {
        const auto row = static_cast<std::size_t>(std::clamp(at.y, 0, grid.ny - 1));
        return ground_m[row * static_cast<std::size_t>(grid.nx) +
                        static_cast<std::size_t>(std::clamp(at.x, 0, grid.nx - 1))];
    }

#include "maths/mask_kinds.glsl"

#include "maths/mask.glsl"
};

}  // namespace talus::maths

namespace talus {
namespace {

template <typename Of>
std::vector<float> at_samples(const Grid& grid, const std::vector<float>& ground_m, Of&& of) {
    maths::GroundShapeTwin twin{grid, ground_m, glm::vec2(grid.dx, grid.dy)};
    std::vector<float> values;
    values.reserve(grid.count());
    for (int y = 0; y < grid.ny; ++y)
        for (int x = 0; x < grid.nx; ++x) values.push_back(of(twin, glm::ivec2(x, y)));
    return values;
}

}  // namespace

std::vector<float> slopes_deg(const Grid& grid, const std::vector<float>& ground_m) {
    return at_samples(grid, ground_m, [](auto& twin, glm::ivec2 at) { return twin.mask_slope(at); });
}

std::vector<float> curvatures_per_km(const Grid& grid, const std::vector<float>& ground_m) {
    return at_samples(grid, ground_m, [](auto& twin, glm::ivec2 at) { return twin.mask_curvature(at); });
}

}  // namespace talus
