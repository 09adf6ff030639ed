// The water against exact solutions: relative L1 of depth (docs/numerics.md, "Water"; the table that this prints is in
// docs/benchmarks.md).
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>

#include "sim/gpu/context.h"
#include "sim/passes/water_twin.h"
#include "tests/scenes/water_scenes.h"

namespace talus {
namespace {

using scenes::WaterRun;
using scenes::WaterScene;

double error_of(const WaterScene& scene) {
    WaterRun run(scene.state(), scene.settings);
    run.run(scene.tick_s, scene.end_s);
    const double error = depth_error(scene, run.read(), scene.end_s);
    const Water::Work work = run.water.work();
    fmt::print("{:<16} n {:>4}  order {}  L1 {:.3e}  {} sub-steps\n", scene.name, scene.grid.nx,
               scene.settings.order, error, work.substeps);
    return error;
}

double order_of(double coarse, double fine, double refinement) {
    return std::log(coarse / fine) / std::log(refinement);
}

TEST(Water, RitterAndStoker) {
    const gpu::Context context;
    for (const auto& make : {scenes::ritter, scenes::stoker}) {
        std::vector<double> errors;
        for (const int n : {100, 200, 400, 800}) errors.push_back(error_of(make(n)));
        EXPECT_LE(errors[0], make == scenes::ritter ? 9e-3 : 6e-3);
        EXPECT_GE(order_of(errors[0], errors[3], 8), 0.8);
        fmt::print("order {:.2f}\n", order_of(errors[0], errors[3], 8));
    }
}

TEST(Water, ThackerBowls) {
    const gpu::Context context;
    for (const auto& make : {scenes::thacker_radial, scenes::thacker_planar}) {
        std::vector<double> errors;
        for (const int n : {64, 128, 256}) errors.push_back(error_of(make(n)));
        EXPECT_LE(errors[1], make == scenes::thacker_radial ? 2.0e-2 : 1.5e-2);
        EXPECT_GE(order_of(errors[0], errors[2], 4), 1.5);
        fmt::print("order {:.2f}\n", order_of(errors[0], errors[2], 4));
    }
}

}  // namespace
}  // namespace talus
