// What a dab costs, and whether that depends on the map: 200 dabs of 256 m radius on 512 and on 4096 samples
// a side, each with its tiles kept for undo, and the picture after every tenth.
#include <fmt/format.h>

#include <cmath>

#include "render/overview.h"
#include "render/renderer.h"
#include "sim/simulation.h"
#include "sim/simulation_parameters.h"
#include "sim/terrain/generate.h"
#include "tests/bench/measure.h"

namespace talus::bench {
namespace {

struct Place {
    Place(int n, double patch_pixels)
        : simulation(state_of(n), Parameters(simulation_parameters()), std::size_t{1} << 30U),
          renderer(simulation.terrain(), patch_pixels) {
        const Grid& grid = simulation.terrain().grid();
        camera = render::overview({512, 512, grid.dx, grid.dy}, 0, 900);
        render::ViewSettings settings;
        renderer.draw(simulation.terrain(), camera, settings, 640, 360);
    }
    static TerrainState state_of(int n) {
        const Grid grid{n, n, 10, 10};
        return bedrock_terrain(grid, generate_heights(grid, {"hills", 4, 900}));
    }
    // A stroke of 200 dabs around a circle of the south-western 5 km.
    void stroke() {
        simulation.begin_stroke("raise");
        for (int i = 0; i < 200; ++i) {
            Dab dab;
            dab.x_m = 2500 + 1500 * std::cos(i * 0.0314);
            dab.y_m = 2500 + 1500 * std::sin(i * 0.0314);
            dab.radius_m = 256;
            dab.amount_m = 0.5;
            simulation.apply(dab);
        }
        simulation.end_entry();
    }
    // Half a second of the tool erode, as a window makes it.
    void erosion() {
        simulation.begin_stroke("erode");
        for (int i = 0; i < 16; ++i) {
            Dab dab;
            dab.x_m = 2500 + 10 * i;
            dab.y_m = 2500;
            dab.radius_m = 256;
            dab.effect = ErodeDab{5000, 2, 3000, i == 0, i == 15};
            simulation.apply(dab);
        }
        simulation.end_entry();
    }
    // One dab, and the picture with it.
    void dab_and_picture() {
        Dab dab;
        dab.x_m = dab.y_m = 2500;
        dab.radius_m = 256;
        dab.amount_m = 0.5;
        simulation.apply(dab);
        renderer.draw(simulation.terrain(), camera, render::ViewSettings(), 640, 360);
        const std::vector<std::uint8_t> wait = renderer.read_rgb(1, 1);
    }
    Simulation simulation;
    render::Renderer renderer;
    render::Camera camera;
};

}  // namespace

void bench_sculpt(double patch_pixels) {
    Place small(512, patch_pixels);
    Place large(4096, patch_pixels);
    const std::vector<double> strokes =
        interleave({{"stroke, 512", [&] { small.stroke(); }}, {"stroke, 4096", [&] { large.stroke(); }}}, 9);
    const std::vector<double> erosions = interleave(
        {{"erosion, 512", [&] { small.erosion(); }}, {"erosion, 4096", [&] { large.erosion(); }}}, 9);
    const std::vector<double> pictures =
        interleave({{"dab and picture, 512", [&] { small.dab_and_picture(); }},
                    {"dab and picture, 4096", [&] { large.dab_and_picture(); }}},
                   9);
    fmt::print(
        "200 dabs of 256 m, time of a dab: 512 a side {:.3f} ms, 4096 a side {:.3f} ms, ratio {:.2f}\n",
        5 * strokes[0], 5 * strokes[1], strokes[1] / strokes[0]);
    fmt::print(
        "16 dabs of erosion of 256 m and 2 s each, time of a dab: 512 a side {:.2f} ms, 4096 a side {:.2f} "
        "ms, "
        "ratio {:.2f}\n",
        62.5 * erosions[0], 62.5 * erosions[1], erosions[1] / erosions[0]);
    fmt::print("a dab and the picture after it: 512 a side {:.2f} ms, 4096 a side {:.2f} ms\n",
               1e3 * pictures[0], 1e3 * pictures[1]);
}

}  // namespace talus::bench
