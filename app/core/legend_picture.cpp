#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>

#include <algorithm>
#include <cmath>

#include "app/core/legend.h"

namespace talus::app {
namespace {

// A font of 15 pixels from line to line, as panels have it: its em, and how far below a text's upper corner
// its baseline lies.
constexpr int em_px = 13;
constexpr float line_px = 17;
constexpr int baseline_px = 12;

// How much of the pixel lies within the box's rounded corners.
float covered(const LegendDrawing::Box& box, glm::vec2 pixel) {
    const glm::vec2 middle = (box.low + box.high) / 2.0F;
    const glm::vec2 beyond = glm::abs(pixel - middle) - (box.high - box.low) / 2.0F + box.rounding;
    const float distance = glm::length(glm::max(beyond, 0.0F)) + std::min(std::max(beyond.x, beyond.y), 0.0F);
    return std::clamp(box.rounding - distance + 0.5F, 0.0F, 1.0F);
}

void blend(const LegendDrawing::Box& box, glm::ivec2 size, std::vector<std::uint8_t>& rgb) {
    const glm::ivec2 low = glm::max(glm::ivec2(glm::floor(box.low)), 0);
    const glm::ivec2 high = glm::min(glm::ivec2(glm::ceil(box.high)), size);
    for (int y = low.y; y < high.y; ++y)
        for (int x = low.x; x < high.x; ++x) {
            const float share = covered(box, glm::vec2(x, y) + 0.5F) * static_cast<float>(box.colour.a) / 255;
            for (int c = 0; c < 3; ++c) {
                std::uint8_t& there = rgb[3 * (static_cast<std::size_t>(y) * size.x + x) + c];
                const auto before = static_cast<float>(there);
                there = static_cast<std::uint8_t>(
                    std::lround(before + share * (static_cast<float>(box.colour[c]) - before)));
            }
        }
}

}  // namespace

void draw_legends(const std::vector<render::Legend>& legends, glm::ivec2 size,
                  std::vector<std::uint8_t>& rgb) {
    if (legends.empty()) return;
    const std::string font = font_file();
    const auto width_of = [&](const std::string& text) {
        return static_cast<float>(OIIO::ImageBufAlgo::text_size(text, em_px, font).width());
    };
    const LegendDrawing drawing = legend_drawing(legends, size, line_px, width_of);
    for (const LegendDrawing::Box& box : drawing.boxes) blend(box, size, rgb);
    OIIO::ImageBuf picture(OIIO::ImageSpec(size.x, size.y, 3, OIIO::TypeDesc::UINT8), rgb.data());
    for (const LegendDrawing::Text& text : drawing.texts)
        OIIO::ImageBufAlgo::render_text(picture, static_cast<int>(text.at.x),
                                        static_cast<int>(text.at.y) + baseline_px, text.words, em_px, font,
                                        {1.0F, 1.0F, 1.0F});
}

}  // namespace talus::app
