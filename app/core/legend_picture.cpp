#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/core/legend.h"
#include "app/core/report.h"

namespace talus::app {
namespace {

// A font of 15 pixels from line to line, as panels have it: its em, and how far below a text's upper corner
// its baseline lies.
constexpr int em_px = 13;
constexpr float line_px = 17;
constexpr int baseline_px = 12;

// How much of the pixel lies within the box's rounded corners.
float covered(const LegendDrawing::Box& box, glm::vec2 pixel) {
    // Boxes without round corners end at pixels, so that those side by side leave nothing between them.
    if (box.rounding <= 0)
        return glm::all(glm::greaterThanEqual(pixel, box.low)) && glm::all(glm::lessThan(pixel, box.high))
                   ? 1.0F
                   : 0.0F;
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

// OpenImageIO ends the program where a text lies outside of its picture, and this one may be smaller than its
// legend: the text gets a picture of its own.
void blend(const LegendDrawing::Text& text, int width, glm::ivec2 size, std::vector<std::uint8_t>& rgb) {
    constexpr int room = 4;
    const glm::ivec2 extent(width + 2 * room, static_cast<int>(line_px) + 2 * room);
    std::vector<std::uint8_t> shares(static_cast<std::size_t>(extent.x) * extent.y);
    OIIO::ImageBuf picture(OIIO::ImageSpec(extent.x, extent.y, 1, OIIO::TypeDesc::UINT8), shares.data());
    OIIO::ImageBufAlgo::render_text(picture, room, room + baseline_px, text.words, em_px, font_file(),
                                    {1.0F});
    const glm::ivec2 corner = glm::ivec2(text.at) - room;
    for (int y = 0; y < extent.y; ++y)
        for (int x = 0; x < extent.x; ++x) {
            const glm::ivec2 at = corner + glm::ivec2(x, y);
            if (at.x < 0 || at.y < 0 || at.x >= size.x || at.y >= size.y) continue;
            const int share = shares[static_cast<std::size_t>(y) * extent.x + x];
            for (int c = 0; c < 3; ++c) {
                std::uint8_t& there = rgb[3 * (static_cast<std::size_t>(at.y) * size.x + at.x) + c];
                there = static_cast<std::uint8_t>(there + share * (255 - there) / 255);
            }
        }
}

}  // namespace

void draw_legends(const std::vector<render::Legend>& legends, glm::ivec2 size,
                  std::vector<std::uint8_t>& rgb) {
    if (legends.empty()) return;
    const auto width_of = [](const std::string& text) {
        const OIIO::ROI extent = OIIO::ImageBufAlgo::text_size(text, em_px, font_file());
        return extent.defined() ? static_cast<float>(extent.width()) : 0.0F;
    };
    const LegendDrawing drawing = legend_drawing(legends, size, line_px, width_of);
    for (const LegendDrawing::Box& box : drawing.boxes) blend(box, size, rgb);
    for (const LegendDrawing::Text& text : drawing.texts)
        blend(text, static_cast<int>(width_of(text.words)), size, rgb);
}

}  // namespace talus::app
