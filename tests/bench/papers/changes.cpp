// What methods hold and what they cost when the ground changes.
#include <fmt/format.h>

#include <functional>

#include "sim/passes/brush.h"
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

}  // namespace talus::bench
