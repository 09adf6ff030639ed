// What a frame costs besides its rays: the shading of every view, with and without shadows.
#include <fmt/format.h>

#include "render/overview.h"
#include "render/renderer.h"
#include "sim/terrain/generate.h"
#include "tests/bench/measure.h"

namespace talus::bench {
namespace {}  // namespace

void bench_frame(double patch_pixels) {
    const Grid grid{2049, 2049, 10, 10};
    Terrain terrain(bedrock_terrain(grid, generate_heights(grid, {"mountains", 4, 2500})));
    render::Renderer renderer(terrain, patch_pixels);
    const double e = grid.width_m();
    const std::vector<std::pair<std::string, render::Camera>> cameras = {
        {"fly", {{0.15 * e, 0.1 * e, 3600}, {0.55 * e, 0.6 * e, 800}, 55}},
        {"overview", render::overview(grid, 0, 2500)}};
    for (const auto& named : cameras) {
        const render::Camera& camera = named.second;
        std::vector<Contestant> contestants;
        for (const render::View& view : render::views()) {
            render::ViewSettings settings;
            settings.view = view.name;
            settings.shadows = false;
            contestants.push_back({view.name, [&, settings] {
                                       renderer.forget();
                                       renderer.draw(terrain, camera, settings, width, height);
                                       const std::vector<std::uint8_t> wait = renderer.read_rgb(1, 1);
                                   }});
        }
        render::ViewSettings shadows;
        contestants.push_back({"shaded, shadows", [&, shadows] {
                                   renderer.forget();
                                   renderer.draw(terrain, camera, shadows, width, height);
                                   const std::vector<std::uint8_t> wait = renderer.read_rgb(1, 1);
                               }});
        const std::vector<double> seconds = interleave(contestants, 7);
        for (std::size_t i = 0; i < contestants.size(); ++i)
            fmt::print("{:<10} {:<18} {:>8.1f} ms\n", named.first, contestants[i].name, 1e3 * seconds[i]);
    }
}

}  // namespace talus::bench
