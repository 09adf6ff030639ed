// What a small change costs: refreshing the pyramid after one dab, on terrains of growing size.
#include <fmt/format.h>

#include <memory>

#include "render/pyramid.h"
#include "sim/passes/brush.h"
#include "sim/terrain/generate.h"
#include "tests/bench/measure.h"

namespace talus::bench {

void bench_update() {
    struct Case {
        explicit Case(const Grid& grid)
            : terrain(bedrock_terrain(grid, generate_heights(grid, {"hills", 2, 500}))),
              pyramid(terrain),
              brush(terrain) {
            pyramid.refresh(terrain);
        }
        Terrain terrain;
        Pyramid pyramid;
        Brush brush;
    };
    std::vector<std::unique_ptr<Case>> cases;
    std::vector<Contestant> contestants;
    const std::vector<int> sizes = {512, 1024, 2048, 4096};
    for (const int size : sizes) {
        cases.push_back(std::make_unique<Case>(Grid{size, size, 10, 10}));
        Case& here = *cases.back();
        const auto dab = [&here] {
            const Grid& grid = here.terrain.grid();
            here.brush.dab(here.terrain, {BrushMode::raise, grid.width_m() / 2, grid.height_m() / 2, 320, 1,
                                          1, 0, 0, false});
        };
        contestants.push_back({fmt::format("{}² dab", size), [dab] {
                                   for (int i = 0; i < 50; ++i) dab();
                               }});
        contestants.push_back({fmt::format("{}² dab and refresh", size), [dab, &here] {
                                   for (int i = 0; i < 50; ++i) {
                                       dab();
                                       here.pyramid.refresh(here.terrain);
                                   }
                               }});
    }
    const std::vector<double> seconds = interleave(contestants, 9);
    fmt::print(
        "a dab of 64 x 64 samples, then the pyramid's refresh; CPU time of one\n{:<8} {:>10} {:>12} {:>10}\n",
        "samples", "dab ms", "refresh ms", "to 512²");
    for (std::size_t i = 0; i < sizes.size(); ++i) {
        const double dab_ms = seconds[2 * i] * 20;
        const double refresh_ms = (seconds[2 * i + 1] - seconds[2 * i]) * 20;
        fmt::print("{:<8} {:>10.3f} {:>12.3f} {:>10.2f}\n", sizes[i], dab_ms, refresh_ms,
                   refresh_ms / ((seconds[1] - seconds[0]) * 20));
    }
}

}  // namespace talus::bench
