#include "sim/terrain/blur.h"

#include <algorithm>
#include <cmath>

#include "shaders/maths/twin.h"
#include "sim/terrain/filter.h"

namespace talus::maths {

// How a brush changes a sample, on the CPU.
struct SolidTwin {
    TALUS_TWIN_NAMES(float)
#include "maths/solid.glsl"
};

}  // namespace talus::maths

namespace talus {
namespace {

// A plane of samples blurred by a Gaussian of this standard deviation (samples east and south), its edge
// repeated.
std::vector<double> blurred(const std::vector<double>& plane, const Grid& grid, glm::dvec2 deviation) {
    const auto along = [](int count, double sigma) {
        return taps_of(
            count, count, [](int i) { return static_cast<double>(i); }, 4 * sigma,
            [sigma](double x) { return std::exp(-0.5 * x * x / (sigma * sigma)); });
    };
    return filtered(plane, grid.nx, along(grid.nx, deviation.x), along(grid.ny, deviation.y));
}

}  // namespace

void blur_ground(Terrain& terrain, glm::dvec2 deviation, bool masked) {
    if (masked && !terrain.painted) return;
    const Grid& grid = terrain.grid();
    std::vector<glm::vec4> solid = terrain.solid.front.read_all<glm::vec4>();
    std::vector<glm::vec4> painted;
    if (masked) painted = terrain.painted->read_all<glm::vec4>();
    std::vector<double> ground(solid.size());
    std::transform(solid.begin(), solid.end(), ground.begin(), [](const glm::vec4& s) {
        return (static_cast<double>(s.x) + s.z) + (static_cast<double>(s.y) + s.w);
    });
    const std::vector<double> target = blurred(ground, grid, deviation);
    maths::SolidTwin twin;
    for (std::size_t i = 0; i < solid.size(); ++i) {
        const auto change = static_cast<float>((target[i] - ground[i]) * (masked ? painted[i].y : 1.0F));
        // Roundings of the mean are no change: what is level stays as it is, to the bit.
        if (std::abs(change) < 1e-9F) continue;
        solid[i] = twin.change_ground(solid[i], change, false);
    }
    const gpu::Region all = terrain.ground.whole();
    terrain.solid.front.write(all, std::as_bytes(std::span(solid)));
    terrain.refresh(all);
}

void blur_mask(Terrain& terrain, glm::dvec2 deviation) {
    if (!terrain.painted) return;
    const Grid& grid = terrain.grid();
    std::vector<glm::vec4> painted = terrain.painted->read_all<glm::vec4>();
    std::vector<double> mask(painted.size());
    std::transform(painted.begin(), painted.end(), mask.begin(), [](const glm::vec4& p) { return p.y; });
    const std::vector<double> target = blurred(mask, grid, deviation);
    for (std::size_t i = 0; i < painted.size(); ++i)
        painted[i].y = static_cast<float>(std::clamp(target[i], 0.0, 1.0));
    terrain.painted->write(terrain.painted->whole(), std::as_bytes(std::span(painted)));
    terrain.tiles.mark_all();
}

}  // namespace talus
