#include "app/core/still.h"

#include <algorithm>

#include "app/core/legend.h"

namespace talus::app {
namespace {

constexpr int largest_part = 2048;

}  // namespace

void drape(render::Renderer& renderer, const Scene& scene) {
    const io::ColourImage& picture = scene.draping.picture;
    renderer.drape(picture.width, picture.height, std::as_bytes(std::span(picture.rgba)));
}

StillPainter painter_of(render::Renderer& renderer, const Terrain& terrain,
                        const render::ViewSettings& settings) {
    return {{},
            [&, settings](const render::Camera& camera, glm::ivec2 size) {
                renderer.forget();
                renderer.draw(terrain, camera, settings, size.x, size.y);
            },
            [&](int samples) { return renderer.refine(terrain, samples); },
            [&](glm::ivec2 size) { return renderer.read_rgb(size.x, size.y); },
            [&](glm::ivec2 size) { return renderer.read_depth(size.x, size.y); }};
}

Still draw_still(const StillPainter& painter, const render::Camera& camera,
                 const std::vector<render::Legend>& legends, glm::ivec2 size, int samples) {
    const std::size_t pixels = static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
    Still still{std::vector<std::uint8_t>(3 * pixels), std::vector<float>(pixels)};
    if (painter.begin) painter.begin(camera, size);
    for (int top = 0; top < size.y; top += largest_part)
        for (int left = 0; left < size.x; left += largest_part) {
            const glm::ivec2 part = glm::min(size - glm::ivec2(left, top), glm::ivec2(largest_part));
            render::Camera here = camera;
            here.window_share = glm::dvec2(part) / glm::dvec2(size);
            // Pictures are numbered from the top, the view's window from below.
            here.window_middle =
                glm::dvec2(2 * left + part.x - size.x, size.y - 2 * top - part.y) / glm::dvec2(size);
            painter.draw(here, part);
            while (painter.refine(samples)) {
            }
            const std::vector<std::uint8_t> rgb = painter.read_rgb(part);
            const std::vector<float> depth = painter.read_depth(part);
            for (int y = 0; y < part.y; ++y) {
                const std::size_t from = static_cast<std::size_t>(y) * part.x;
                const std::size_t to = static_cast<std::size_t>(top + y) * size.x + left;
                std::copy_n(rgb.begin() + static_cast<std::ptrdiff_t>(3 * from), 3 * part.x,
                            still.rgb.begin() + static_cast<std::ptrdiff_t>(3 * to));
                std::copy_n(depth.begin() + static_cast<std::ptrdiff_t>(from), part.x,
                            still.depth_m.begin() + static_cast<std::ptrdiff_t>(to));
            }
        }
    draw_legends(legends, size, still.rgb);
    return still;
}

}  // namespace talus::app
