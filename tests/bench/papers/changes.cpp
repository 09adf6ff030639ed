// What methods hold and what they cost when the ground changes.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>

#include "render/renderer.h"
#include "sim/passes/brush.h"
#include "sim/simulation.h"
#include "sim/simulation_parameters.h"
#include "tests/bench/measure.h"
#include "tests/bench/papers/easel.h"
#include "tests/bench/papers/table.h"
#include "tests/bench/papers/tables.h"

namespace talus::bench {

// A frame of each method at rest, after a dab of 64 x 64 samples in the middle, and after a change of
// everything; the pyramid's refresh is in it. Bytes: of the method alone, and of the pyramid.
void changes(const PaperRun& run) {
    Table table("changes",
                "terrain,method,bytes_per_sample,pyramid_bytes_per_sample,at_rest_ms,after_a_dab_ms,"
                "after_everything_ms");
    for (const std::string& name : run.terrains) {
        const PaperTerrain terrain = paper_terrain(name);
        const Grid& grid = terrain.grid;
        PaperEasel easel(terrain, small_picture, run.patch_pixels);
        Brush brush(easel.terrain());
        double amount_m = 1;
        const auto dab = [&] {
            brush.dab(easel.terrain(), {RaiseDab{}, grid.width_m() / 2, grid.height_m() / 2, 32 * grid.dx, 1,
                                        amount_m, 0, 0, Material::bedrock});
            amount_m = -amount_m;
            easel.pyramid().refresh(easel.terrain());
        };
        const auto everything = [&] {
            easel.terrain().tiles.mark_all();
            easel.pyramid().refresh(easel.terrain());
        };
        const render::Camera camera = paper_flight(terrain, 5)[2];
        for (const Entry& one : {entry("hybrid"), entry("exact"), entry("boxes"), entry("relief"),
                                 entry("ammann"), clipmap(3, 11, "clipmap n 511"),
                                 clipmap(1, 13, "clipmap n 127"), entry("mesh"), entry("uniform")}) {
            // Not turn by turn: a thread that follows the last change would be in the next figure.
            const auto median_ms = [&](const std::string& when, const std::function<void()>& change) {
                if (one.method.finish) one.method.finish(easel.terrain());
                return 1e3 * interleave({{when,
                                          [&] {
                                              change();
                                              easel.draw(one, camera);
                                          }}},
                                        5)
                                 .front();
            };
            const double at_rest_ms = median_ms("at rest", [] {});
            const double after_dab_ms = median_ms("after a dab", dab);
            const double after_everything_ms = median_ms("after everything", everything);
            const auto samples = static_cast<double>(grid.count());
            table.row(fmt::format("{},{},{:.2f},{:.2f},{:.1f},{:.1f},{:.1f}", name, one.name,
                                  static_cast<double>(one.method.figures().bytes) / samples,
                                  static_cast<double>(easel.pyramid().bytes()) / samples, at_rest_ms,
                                  after_dab_ms, after_everything_ms));
        }
    }
}

namespace {

// Mountains whose slopes slide, or whose lowest 900 m lie under water that runs in waves.
std::unique_ptr<Simulation> moving(const PaperTerrain& terrain, bool erodes) {
    TerrainState state = bedrock_terrain(terrain.grid, terrain.heights);
    if (!erodes) {
        state.water.assign(terrain.grid.count(), glm::vec4(0));
        for (std::size_t i = 0; i < terrain.grid.count(); ++i) {
            const auto column = static_cast<float>(i % terrain.grid.nx);
            state.water[i].x = std::max(900 + 2 * std::sin(0.05F * column) - terrain.heights[i], 0.0F);
        }
    }
    Parameters all(simulation_parameters());
    for (const char* assignment : {"time.tick_s=0.1", "thermal.scheme=olsen_fast", "thermal.repose_deg=20"})
        all.set_assignment(assignment);
    all.set("thermal.on", erodes);
    all.set("water.on", !erodes);
    return std::make_unique<Simulation>(state, all);
}

}  // namespace

// Ammann 2010, figure 11: a whole picture, with colours and water, at rest; a tick of 100 ms of erosion or of
// waves over all of the terrain; and the whole picture after it, with the refresh of what follows the
// terrain.
void ammann_figure_11(const PaperRun& run) {
    Table table("ammann_figure_11", "samples,process,method,at_rest_ms,tick_ms,after_the_tick_ms");
    for (const int side : {1024, 2048}) {
        const PaperTerrain terrain = paper_terrain_of(side);
        const render::Camera camera = paper_flight(terrain, 5)[2];
        for (const bool erodes : {true, false})
            for (const char* method : {"ammann", "exact", "hybrid"}) {
                // Each method has the same ticks.
                const std::unique_ptr<Simulation> simulation = moving(terrain, erodes);
                render::Renderer renderer(simulation->terrain(), run.patch_pixels);
                render::ViewSettings settings;
                settings.method = method;
                settings.shadows = settings.occlusion = false;
                const auto wait = [&] { const auto pixel = renderer.read_rgb(1, 1); };
                const auto draw = [&] {
                    // Everything, or some methods would draw changed blocks alone.
                    renderer.forget();
                    renderer.draw(simulation->terrain(), camera, settings, small_picture.x, small_picture.y);
                    wait();
                };
                const auto tick = [&] {
                    simulation->apply(Ticks{1});
                    wait();
                };
                const std::vector<double> seconds =
                    interleave({{"at rest", draw}, {"tick", tick}, {"after it", draw}}, 5);
                table.row(fmt::format("{},{},{},{:.1f},{:.1f},{:.1f}", side, erodes ? "erosion" : "waves",
                                      method, 1e3 * seconds[0], 1e3 * seconds[1], 1e3 * seconds[2]));
            }
    }
}

}  // namespace talus::bench
