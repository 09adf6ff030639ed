#include "app/core/legend.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "shaders/maths/twin.h"
#include "sim/figure.h"

namespace talus::maths {

// The colours that the shader uses.
template <typename Real>
struct ColourTwin {
    TALUS_TWIN_NAMES(Real)
#include "maths/colour_map.glsl"
};

}  // namespace talus::maths

namespace talus::app {
namespace {

constexpr float margin = 14;
constexpr float bar_width = 240;
constexpr float bar_height = 14;
constexpr glm::u8vec4 background(18, 20, 24, 225);

glm::u8vec4 opaque(glm::vec3 c) {
    return {glm::round(255.0F * glm::clamp(c, 0.0F, 1.0F)), 255};
}

glm::u8vec4 colour_at(const render::Legend& legend, float share) {
    maths::ColourTwin<float> twin;
    switch (legend.scale) {
        case render::Legend::Scale::grey:
            return opaque(glm::vec3(share));
        case render::Legend::Scale::direction:
            return opaque(twin.direction_map(share));
        case render::Legend::Scale::difference:
            return opaque(twin.difference_map(share));
        default:
            return opaque(twin.colour_map(share));
    }
}

// What single colours mean, a line each.
void add_kinds(LegendDrawing& drawing, const render::Legend& legend, glm::vec2 corner, float line_px) {
    for (const auto& [kind, name] : legend.kinds) {
        drawing.boxes.push_back({corner + glm::vec2(0, 2), corner + glm::vec2(22, line_px - 3),
                                 opaque(maths::ColourTwin<float>().kind_map(static_cast<float>(kind)))});
        drawing.texts.push_back({corner + glm::vec2(30, 0), name});
        corner.y += line_px;
    }
}

void add_bar(LegendDrawing& drawing, const render::Legend& legend, glm::vec2 corner,
             const std::function<float(const std::string&)>& width_of) {
    const int steps =
        legend.bands > 0 ? std::min(legend.bands, static_cast<int>(bar_width)) : static_cast<int>(bar_width);
    for (int i = 0; i < steps; ++i) {
        const float share = steps > 1 ? static_cast<float>(i) / static_cast<float>(steps - 1) : 0;
        const float from = bar_width * static_cast<float>(i) / static_cast<float>(steps);
        const float to = bar_width * static_cast<float>(i + 1) / static_cast<float>(steps);
        drawing.boxes.push_back(
            {corner + glm::vec2(from, 0), corner + glm::vec2(to, bar_height), colour_at(legend, share)});
    }
    const std::string middle = figure((legend.low + legend.high) / 2, 6);
    const std::string high = figure(legend.high, 6);
    const glm::vec2 below = corner + glm::vec2(0, bar_height + 3);
    drawing.texts.push_back({below, figure(legend.low, 6)});
    drawing.texts.push_back({below + glm::vec2((bar_width - width_of(middle)) / 2, 0), middle});
    drawing.texts.push_back({below + glm::vec2(bar_width - width_of(high), 0), high});
}

}  // namespace

LegendDrawing legend_drawing(const std::vector<render::Legend>& legends, glm::ivec2 size, float line_px,
                             const std::function<float(const std::string&)>& width_of) {
    LegendDrawing drawing;
    glm::vec2 corner = glm::vec2(size) - margin;  // the lower right one of the next legend
    for (const render::Legend& legend : legends) {
        const bool bar = legend.scale != render::Legend::Scale::none;
        const float rows = bar ? line_px + bar_height : line_px * static_cast<float>(legend.kinds.size());
        const glm::vec2 low = corner - glm::vec2(bar_width + 24, line_px + rows + 18);
        drawing.boxes.push_back({low, corner, background, 5});
        drawing.texts.push_back(
            {low + glm::vec2(12, 6), bar ? fmt::format("{} ({})", legend.title, legend.unit) : legend.title});
        const glm::vec2 inside = low + glm::vec2(12, 8 + line_px);
        if (bar)
            add_bar(drawing, legend, inside, width_of);
        else
            add_kinds(drawing, legend, inside, line_px);
        corner.y = low.y - 8;
    }
    return drawing;
}

std::string font_file() {
    constexpr const char* path = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf";
    return std::filesystem::exists(path) ? path : "";
}

}  // namespace talus::app
