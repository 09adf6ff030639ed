// What the rest of a terrain around a part that was cut out costs.
#include <fmt/format.h>

#include "render/renderer.h"
#include "render/tiled/backdrop.h"
#include "render/tiled/tiled_renderer.h"
#include "sim/terrain/generate.h"
#include "tests/bench/measure.h"
#include "tests/scenes/load_tiles.h"

namespace talus::bench {
namespace {

constexpr Grid around_grid{4097, 4097, 5, 5};
constexpr glm::ivec2 part_first(1536, 1536);
constexpr Grid part_grid{1025, 1025, 5, 5};
constexpr glm::ivec2 backdrop_picture(width, height);

std::vector<float> part_of(const std::vector<float>& heights) {
    std::vector<float> part;
    part.reserve(part_grid.count());
    for (int y = 0; y < part_grid.ny; ++y)
        for (int x = 0; x < part_grid.nx; ++x)
            part.push_back(
                heights[static_cast<std::size_t>(part_first.y + y) * around_grid.nx + part_first.x + x]);
    return part;
}

}  // namespace

void bench_backdrop(double patch_pixels) {
    const std::vector<float> heights = generate_heights(around_grid, {"mountains", 4, 2500});
    const scenes::MemoryTiles tiles(around_grid, heights, 512);
    render::TiledSurface surface(tiles.tree(), tiles.bounds(), static_cast<int>(tiles.tree().count()));
    scenes::put_coarsest(surface, tiles);
    const std::vector<float> part = part_of(heights);
    Terrain terrain(bedrock_terrain(part_grid, part));
    render::Renderer alone(terrain, patch_pixels);
    render::Renderer before(terrain, patch_pixels);
    render::TiledRenderer whole;
    render::Backdrop backdrop(surface, part_grid, part_first);
    before.stand_before(&backdrop);
    // In the part's metres: it fills the picture, it lies in the middle of it, and from within it out over
    // the rest.
    const std::vector<std::pair<std::string, render::Camera>> cameras = {
        {"the part fills it", {{1000, -1500, 4200}, {2500, 2700, 1000}, 45}},
        {"in the middle", {{-2500, -5500, 6000}, {2500, 2500, 800}, 50}},
        {"out of it", {{2500, 2500, 3000}, {9000, 7500, 500}, 55}}};
    for (const auto& named : cameras) {
        const render::Camera& camera = named.second;
        render::ViewSettings settings;
        settings.tolerance_px = 2.0 / 3;
        settings.sun = glm::normalize(glm::dvec3(-0.7, 0.6, 0.5));
        const render::Camera over_tiles = backdrop.camera_over_tiles(camera);
        scenes::load_tiles(surface, tiles, over_tiles, backdrop_picture, settings.tolerance_px);
        backdrop.note_change();
        const auto draw = [&](render::Renderer& renderer, bool anew) {
            if (anew) renderer.forget();
            renderer.draw(terrain, camera, settings, width, height);
            const std::vector<std::uint8_t> wait = renderer.read_rgb(1, 1);
        };
        // Raises and lowers ground in the part's middle by 60 m, in turn.
        bool raised = false;
        const auto dab = [&] {
            raised = !raised;
            const gpu::Region region{500, 500, 64, 64};
            std::vector<glm::vec4> texels;
            for (int y = region.y; y < region.y + region.height; ++y)
                for (int x = region.x; x < region.x + region.width; ++x)
                    texels.emplace_back(
                        part[static_cast<std::size_t>(y) * part_grid.nx + x] + (raised ? 60.0F : 0.0F), 0, 0,
                        0);
            terrain.solid.front.write(region, std::as_bytes(std::span(texels)));
            terrain.refresh(region);
        };
        const std::vector<Contestant> contestants = {
            {"the whole in tiles",
             [&] {
                 whole.draw(surface, over_tiles, settings, width, height);
                 const std::vector<std::uint8_t> wait = whole.read_rgb(1, 1);
             }},
            {"the part alone", [&] { draw(alone, true); }},
            {"the part and the rest", [&] { draw(before, true); }},
            {"the part alone, after a dab",
             [&] {
                 dab();
                 draw(alone, false);
             }},
            {"the part and the rest, after a dab", [&] {
                 dab();
                 draw(before, false);
             }}};
        const std::vector<double> seconds = interleave(contestants, 7);
        for (std::size_t i = 0; i < contestants.size(); ++i)
            fmt::print("{:<18} {:<36} {:>8.1f} ms\n", named.first, contestants[i].name, 1e3 * seconds[i]);
    }
}

}  // namespace talus::bench
