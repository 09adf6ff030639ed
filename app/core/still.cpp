#include "app/core/still.h"

#include <algorithm>

#include "app/core/legend.h"

namespace talus::app {
namespace {

constexpr int largest_tile = 2048;

}  // namespace

void drape(render::Renderer& renderer, const Scene& scene) {
    renderer.drape(scene.texture.width, scene.texture.height, std::as_bytes(std::span(scene.texture.rgba)));
}

Still draw_still(render::Renderer& renderer, const Terrain& terrain, const render::Camera& camera,
                 const render::ViewSettings& settings, const std::vector<render::Legend>& legends,
                 glm::ivec2 size, int samples) {
    const std::size_t pixels = static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
    Still still{std::vector<std::uint8_t>(3 * pixels), std::vector<float>(pixels)};
    for (int top = 0; top < size.y; top += largest_tile)
        for (int left = 0; left < size.x; left += largest_tile) {
            const glm::ivec2 tile = glm::min(size - glm::ivec2(left, top), glm::ivec2(largest_tile));
            render::Camera here = camera;
            here.window_share = glm::dvec2(tile) / glm::dvec2(size);
            // Pictures are numbered from the top, the view's window from below.
            here.window_middle =
                glm::dvec2(2 * left + tile.x - size.x, size.y - 2 * top - tile.y) / glm::dvec2(size);
            renderer.draw(terrain, here, settings, tile.x, tile.y);
            while (renderer.refine(terrain, samples)) {
            }
            const std::vector<std::uint8_t> rgb = renderer.read_rgb(tile.x, tile.y);
            const std::vector<float> depth = renderer.read_depth(tile.x, tile.y);
            renderer.forget();
            for (int y = 0; y < tile.y; ++y) {
                const std::size_t from = static_cast<std::size_t>(y) * tile.x;
                const std::size_t to = static_cast<std::size_t>(top + y) * size.x + left;
                std::copy_n(rgb.begin() + static_cast<std::ptrdiff_t>(3 * from), 3 * tile.x,
                            still.rgb.begin() + static_cast<std::ptrdiff_t>(3 * to));
                std::copy_n(depth.begin() + static_cast<std::ptrdiff_t>(from), tile.x,
                            still.depth_m.begin() + static_cast<std::ptrdiff_t>(to));
            }
        }
    draw_legends(legends, size, still.rgb);
    return still;
}

}  // namespace talus::app
