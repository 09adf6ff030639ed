#include "sim/terrain/blur.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "shaders/maths/twin.h"
#include "sim/error.h"
#include "sim/terrain/filter.h"

namespace talus::maths {

// How a brush changes a sample, on the CPU.
struct SolidTwin {
    TALUS_TWIN_NAMES(float)
#include "maths/solid.glsl"
#include "maths/wear.glsl"
};

}  // namespace talus::maths

namespace talus {
namespace {

// A plane of samples blurred by a Gaussian, its edge repeated.
std::vector<double> blurred(const std::vector<double>& plane, const Grid& grid, double deviation_m) {
    const double most_m = 256 * std::min(grid.dx, grid.dy);
    if (!(deviation_m > 0 && deviation_m <= most_m))
        throw Error(fmt::format("a blur of {} m cannot be made, it must be above 0 and at most {:.6g} m",
                                deviation_m, most_m));
    const auto along = [&](int count, double spacing_m) {
        const double sigma = deviation_m / spacing_m;
        return taps_of(
            count, count, [](int i) { return static_cast<double>(i); }, 4 * sigma,
            [sigma](double x) { return std::exp(-0.5 * x * x / (sigma * sigma)); });
    };
    return filtered(plane, grid.nx, along(grid.nx, grid.dx), along(grid.ny, grid.dy));
}

}  // namespace

TerrainState with_blurred_ground(TerrainState state, double deviation_m, bool masked) {
    std::vector<double> ground(state.bedrock.size());
    for (std::size_t i = 0; i < ground.size(); ++i) {
        const glm::vec2 bedrock = state.bedrock[i];
        const glm::vec2 regolith = state.regolith[i];
        ground[i] =
            (static_cast<double>(bedrock.x) + regolith.x) + (static_cast<double>(bedrock.y) + regolith.y);
    }
    const std::vector<double> target = blurred(ground, state.grid, deviation_m);
    // Where nothing was painted the mask is 0.
    if (masked && state.painted.empty()) return state;
    if (state.worn_by_hand.empty()) state.worn_by_hand.assign(ground.size(), glm::vec4(0));
    maths::SolidTwin twin;
    for (std::size_t i = 0; i < ground.size(); ++i) {
        const float share = masked ? state.painted[i].y : 1.0F;
        const auto change = static_cast<float>((target[i] - ground[i]) * share);
        // Roundings of the mean are no change: what is level stays as it is, to the bit.
        if (std::abs(change) < 1e-9F) continue;
        const glm::vec4 before(state.bedrock[i], state.regolith[i]);
        const glm::vec4 solid = twin.change_ground(before, change, false);
        state.bedrock[i] = {solid.x, solid.y};
        state.regolith[i] = {solid.z, solid.w};
        state.worn_by_hand[i] = twin.wear_counted(state.worn_by_hand[i], before, solid);
    }
    return state;
}

TerrainState with_blurred_mask(TerrainState state, double deviation_m) {
    std::vector<double> mask(state.painted.size());
    std::transform(state.painted.begin(), state.painted.end(), mask.begin(),
                   [](const glm::vec4& painted) { return painted.y; });
    if (mask.empty()) mask.resize(state.grid.count());
    const std::vector<double> target = blurred(mask, state.grid, deviation_m);
    for (std::size_t i = 0; i < state.painted.size(); ++i)
        state.painted[i].y = static_cast<float>(std::clamp(target[i], 0.0, 1.0));
    return state;
}

}  // namespace talus
