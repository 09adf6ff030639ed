#include "app/panels/legend.h"

#include <imgui.h>

namespace talus::app {

void load_font(float pixels) {
    ImGuiIO& io = ImGui::GetIO();
    static const ImWchar glyphs[] = {0x20, 0xff, 0x2013, 0x2026, 0x2190, 0x2193, 0};
    if (const std::string font = font_file(); !font.empty())
        io.Fonts->AddFontFromFileTTF(font.c_str(), pixels, nullptr, glyphs);
    else
        io.Fonts->AddFontDefault();
}

void draw_legend(const std::vector<render::Legend>& legends, int width, int height) {
    ImDrawList* list = ImGui::GetForegroundDrawList();
    const LegendDrawing drawing =
        legend_drawing(legends, {width, height}, ImGui::GetFontSize() + 2,
                       [](const std::string& text) { return ImGui::CalcTextSize(text.c_str()).x; });
    for (const LegendDrawing::Box& box : drawing.boxes)
        list->AddRectFilled({box.low.x, box.low.y}, {box.high.x, box.high.y},
                            IM_COL32(box.colour.r, box.colour.g, box.colour.b, box.colour.a), box.rounding);
    for (const LegendDrawing::Text& text : drawing.texts)
        list->AddText({text.at.x, text.at.y}, IM_COL32_WHITE, text.words.c_str());
}

}  // namespace talus::app
