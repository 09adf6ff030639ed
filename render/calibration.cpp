#include "render/calibration.h"

#include <time.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "render/hits_target.h"
#include "render/methods/method.h"
#include "sim/terrain/generate.h"

namespace talus::render {
namespace {

constexpr int picture_width = 640;
constexpr int picture_height = 360;
constexpr int rounds = 4;

struct Cost {
    double s = 0;
    double patches = 0;
};

// A software renderer works in this process. CPU time counts, because other programs do not lengthen it.
double now_s(bool software) {
    if (!software)
        return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
    timespec time{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

// The shortest of a few draws, after one that does not count: what disturbs only makes it longer.
Cost cost_of(const Method& method, const Frame& frame, const HitsTarget& target, bool software) {
    Cost cost{HUGE_VAL, 0};
    for (int round = 0; round <= rounds; ++round) {
        const double begin_s = now_s(software);
        method(frame);
        const std::vector<float> wait = target.read_distances(1, 1);
        const double s = now_s(software) - begin_s;
        if (round > 0) cost.s = std::min(cost.s, s);
    }
    cost.patches = static_cast<double>(method.figures().triangles) / 2;
    return cost;
}

}  // namespace

double measure_patch_pixels(bool software) {
    const Grid grid{257, 257, 10, 10};
    Terrain terrain(bedrock_terrain(grid, generate_heights(grid, {"hills", 1, 100})));
    Pyramid pyramid(terrain);
    pyramid.refresh(terrain);
    const HitsTarget target(picture_width, picture_height);
    const Method hybrid = make_hybrid(Detail::none);
    // Straight down, so that ground fills both pictures: few patches, and many.
    const auto down = [&](double above_m) {
        const glm::dvec3 eye(grid.width_m() / 2, grid.height_m() / 2, above_m);
        return Camera{eye, eye - glm::dvec3(0, 0, 1), 50};
    };
    const Camera near = down(300);
    const Camera far = down(1500);
    const auto frame = [&](const Camera& camera, double patch_pixels) {
        return Frame{terrain,        pyramid, camera,       picture_width,
                     picture_height, 0.5,     patch_pixels, target.framebuffer()};
    };
    const Cost few = cost_of(hybrid, frame(near, 0), target, software);
    const Cost many = cost_of(hybrid, frame(far, 0), target, software);
    const Cost rays = cost_of(hybrid, frame(far, HUGE_VAL), target, software);
    constexpr double pixels = static_cast<double>(picture_width) * picture_height;
    const double patch_s = std::max(many.s - few.s, 0.0) / std::max(many.patches - few.patches, 1.0);
    const double pixel_s = (few.s - patch_s * few.patches) / pixels;
    const double saved_s = rays.s / pixels - pixel_s;
    const double exact = saved_s > 0 ? patch_s / saved_s : HUGE_VAL;
    return std::exp2(0.5 * std::round(2 * std::log2(std::clamp(exact, 4.0, 1024.0))));
}

}  // namespace talus::render
