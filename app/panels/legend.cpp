#include "app/panels/legend.h"

#include <backends/imgui_impl_opengl3.h>
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <filesystem>

#include "app/panels/widgets.h"
#include "shaders/maths/twin.h"

namespace talus::maths {

// The colours that the shader uses.
template <typename Real>
struct ColourTwin {
    TALUS_TWIN_NAMES(Real)
#include "maths/colour_map.glsl"
};

}  // namespace talus::maths

namespace talus {
namespace {

ImU32 packed(glm::vec3 c) {
    return ImGui::GetColorU32(ImVec4(c.x, c.y, c.z, 1));
}

ImU32 colour_at(const Legend& legend, float share) {
    maths::ColourTwin<float> twin;
    switch (legend.scale) {
        case Legend::Scale::grey:
            return packed(glm::vec3(share));
        case Legend::Scale::direction:
            return packed(twin.direction_map(share));
        case Legend::Scale::difference:
            return packed(twin.difference_map(share));
        default:
            return packed(twin.colour_map(share));
    }
}

}  // namespace

void load_font(float pixels) {
    constexpr const char* path = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf";
    ImGuiIO& io = ImGui::GetIO();
    static const ImWchar glyphs[] = {0x20, 0xff, 0x2013, 0x2026, 0x2190, 0x2193, 0};
    if (std::filesystem::exists(path))
        io.Fonts->AddFontFromFileTTF(path, pixels, nullptr, glyphs);
    else
        io.Fonts->AddFontDefault();
}

void draw_legend(const std::vector<Legend>& legends, int width, int height) {
    constexpr float margin = 14;
    constexpr float bar_width = 240;
    constexpr float bar_height = 14;
    ImDrawList* list = ImGui::GetForegroundDrawList();
    float bottom = static_cast<float>(height) - margin;
    const float line = ImGui::GetFontSize() + 2;
    for (const Legend& legend : legends) {
        const bool bar = legend.scale != Legend::Scale::none;
        const float rows = bar ? line + bar_height : line * static_cast<float>(legend.kinds.size());
        const float top = bottom - (line + rows + 18);
        const float left = static_cast<float>(width) - margin - bar_width - 24;
        list->AddRectFilled({left, top}, {static_cast<float>(width) - margin, bottom},
                            IM_COL32(18, 20, 24, 225), 5);
        const float x0 = left + 12;
        const float y0 = top + 8 + line;
        list->AddText({x0, top + 6}, IM_COL32_WHITE,
                      (bar ? fmt::format("{} ({})", legend.title, legend.unit) : legend.title).c_str());
        for (std::size_t i = 0; i < legend.kinds.size(); ++i) {
            const float y = y0 + line * static_cast<float>(i);
            const auto& [kind, name] = legend.kinds[i];
            list->AddRectFilled({x0, y + 2}, {x0 + 22, y + line - 3},
                                packed(maths::ColourTwin<float>().kind_map(static_cast<float>(kind))));
            list->AddText({x0 + 30, y}, IM_COL32_WHITE, name.c_str());
        }
        if (!bar) {
            bottom = top - 8;
            continue;
        }
        const int steps = legend.bands > 0 ? std::min(legend.bands, static_cast<int>(bar_width))
                                           : static_cast<int>(bar_width);
        for (int i = 0; i < steps; ++i) {
            const float share = steps > 1 ? static_cast<float>(i) / static_cast<float>(steps - 1) : 0;
            const float from = x0 + bar_width * static_cast<float>(i) / static_cast<float>(steps);
            const float to = x0 + bar_width * static_cast<float>(i + 1) / static_cast<float>(steps);
            list->AddRectFilled({from, y0}, {to, y0 + bar_height}, colour_at(legend, share));
        }
        const std::string low = figure(legend.low, 6);
        const std::string high = figure(legend.high, 6);
        const std::string middle = figure((legend.low + legend.high) / 2, 6);
        const float y1 = y0 + bar_height + 3;
        list->AddText({x0, y1}, IM_COL32_WHITE, low.c_str());
        list->AddText({x0 + (bar_width - ImGui::CalcTextSize(middle.c_str()).x) / 2, y1}, IM_COL32_WHITE,
                      middle.c_str());
        list->AddText({x0 + bar_width - ImGui::CalcTextSize(high.c_str()).x, y1}, IM_COL32_WHITE,
                      high.c_str());
        bottom = top - 8;
    }
}

void draw_legend_into(const gpu::Framebuffer& framebuffer, glm::ivec2 size, glm::ivec2 corner,
                      glm::ivec2 tile, const std::vector<Legend>& legends) {
    if (legends.empty()) return;
    const auto pair = [](glm::ivec2 v) { return ImVec2(static_cast<float>(v.x), static_cast<float>(v.y)); };
    // The window's panels may have a context of their own.
    ImGuiContext* const before = ImGui::GetCurrentContext();
    ImGuiContext* const here = ImGui::CreateContext();
    ImGui::SetCurrentContext(here);
    ImGui::GetIO().IniFilename = nullptr;
    ImGui::GetIO().DisplaySize = pair(size);
    ImGui::GetIO().DeltaTime = 1;
    load_font(15);
    ImGui_ImplOpenGL3_Init("#version 450 core");
    ImGui_ImplOpenGL3_NewFrame();
    ImGui::NewFrame();
    draw_legend(legends, size.x, size.y);
    ImGui::Render();
    framebuffer.bind({0, 0, tile.x, tile.y});
    ImGui::GetDrawData()->DisplayPos = pair(corner);
    ImGui::GetDrawData()->DisplaySize = pair(tile);
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
    ImGui_ImplOpenGL3_Shutdown();
    ImGui::DestroyContext(here);
    ImGui::SetCurrentContext(before);
}

}  // namespace talus
