#include <fmt/format.h>
#include <imgui.h>

#include <cmath>

#include "app/panels/panels.h"
#include "app/panels/widgets.h"

namespace talus::app {
namespace {

// The longest of 1, 2 and 5 times a power of ten that is no longer.
double round_length_m(double most_m) {
    const double power = std::pow(10, std::floor(std::log10(most_m)));
    for (const double times : {5.0, 2.0})
        if (times * power <= most_m) return times * power;
    return power;
}

std::string length_text(double length_m) {
    if (length_m >= 1000) return fmt::format("{:g} km", length_m / 1000);
    return length_m >= 1 ? fmt::format("{:g} m", length_m) : fmt::format("{:g} cm", 100 * length_m);
}

}  // namespace

void draw_scale_bar(const render::Camera& camera, const PictureArea& area) {
    if (!camera.is_parallel()) return;
    const double pixel_m = pixel_width_m(camera, area.size.y, 0);
    const double length_m = round_length_m(0.25 * area.size.x * pixel_m);
    const auto length = static_cast<float>(length_m / pixel_m);
    const ImVec2 low(static_cast<float>(area.corner.x) + 16,
                     static_cast<float>(area.corner.y + area.size.y) - 16);
    const ImU32 dark = IM_COL32(20, 24, 30, 220);
    const ImU32 pale = IM_COL32(240, 242, 245, 255);
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    const float line = ImGui::GetTextLineHeight();
    list.AddRectFilled({low.x - 8, low.y - line - 10}, {low.x + length + 8, low.y + 6}, dark, 4);
    list.AddText({low.x, low.y - line - 6}, pale, length_text(length_m).c_str());
    list.AddLine({low.x, low.y}, {low.x + length, low.y}, pale, 2);
    for (const float x : {low.x, low.x + length}) list.AddLine({x, low.y - 5}, {x, low.y + 1}, pale, 2);
}

}  // namespace talus::app
