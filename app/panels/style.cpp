#include "app/panels/style.h"

#include <imgui.h>

#include <algorithm>

#include "app/panels/legend.h"

namespace talus::app {
namespace {

std::size_t chosen_theme = 0;

ImVec4 as_imgui(glm::vec4 colour) {
    return {colour.r, colour.g, colour.b, colour.a};
}

}  // namespace

const std::array<Theme, 2>& themes() {
    // White words can be read on every one of their grounds (tests/unit/widgets_test.cpp).
    static const std::array<Theme, 2> all = {{
        {.name = "plain",
         .text = {1, 1, 1, 1},
         .faint = {0.62F, 0.64F, 0.67F, 1},
         .heading = {0.62F, 0.78F, 0.95F, 1},
         .warning = {1, 0.7F, 0.3F, 1},
         .good = {0.5F, 0.9F, 0.5F, 1},
         .panel = {0.085F, 0.095F, 0.11F, 0.97F},
         .popup = {0.105F, 0.115F, 0.135F, 1},
         .field = {0.16F, 0.19F, 0.24F, 1},
         .button = {0.20F, 0.24F, 0.30F, 1},
         .hovered = {0.26F, 0.34F, 0.44F, 1},
         .chosen = {0.16F, 0.45F, 0.75F, 1},
         .bar = {0.07F, 0.08F, 0.095F, 1},
         .notice = {0.275F, 0.195F, 0.08F, 0.96F},
         .handle = {0.22F, 0.50F, 0.82F, 1},
         .border = {0.30F, 0.33F, 0.38F, 1},
         .border_px = 0},
        {.name = "high contrast",
         .text = {1, 1, 1, 1},
         .faint = {0.85F, 0.85F, 0.85F, 1},
         .heading = {1, 0.95F, 0.25F, 1},
         .warning = {1, 0.8F, 0.4F, 1},
         .good = {0.5F, 1, 0.5F, 1},
         .panel = {0, 0, 0, 1},
         .popup = {0, 0, 0, 1},
         .field = {0.08F, 0.08F, 0.08F, 1},
         .button = {0.12F, 0.12F, 0.12F, 1},
         .hovered = {0.26F, 0.26F, 0.26F, 1},
         .chosen = {0, 0.30F, 0.70F, 1},
         .bar = {0, 0, 0, 1},
         .notice = {0.30F, 0, 0, 1},
         .handle = {0.15F, 0.45F, 1, 1},
         .border = {0.80F, 0.80F, 0.80F, 1},
         .border_px = 1},
    }};
    return all;
}

const Theme& theme() {
    return themes()[chosen_theme];
}

std::uint32_t colour_of(glm::vec4 colour) {
    return ImGui::ColorConvertFloat4ToU32(as_imgui(colour));
}

void set_theme(const std::string& name) {
    const auto found =
        std::find_if(themes().begin(), themes().end(), [&](const Theme& one) { return one.name == name; });
    chosen_theme = found == themes().end() ? 0 : static_cast<std::size_t>(found - themes().begin());
    const Theme& now = theme();
    ImGui::StyleColorsDark();
    ImGuiStyle& style = ImGui::GetStyle();
    style.WindowBorderSize = style.FrameBorderSize = style.PopupBorderSize = now.border_px;
    const auto give = [&](glm::vec4 colour, std::initializer_list<int> places) {
        for (const int place : places) style.Colors[place] = as_imgui(colour);
    };
    give(now.text, {ImGuiCol_Text});
    give(now.faint, {ImGuiCol_TextDisabled});
    give(now.panel, {ImGuiCol_WindowBg});
    give(now.popup, {ImGuiCol_PopupBg, ImGuiCol_MenuBarBg, ImGuiCol_TitleBg, ImGuiCol_TitleBgActive,
                     ImGuiCol_TableHeaderBg, ImGuiCol_ScrollbarBg});
    give(now.field, {ImGuiCol_FrameBg});
    give(now.button, {ImGuiCol_Button});
    give(now.hovered, {ImGuiCol_ButtonHovered, ImGuiCol_FrameBgHovered, ImGuiCol_HeaderHovered});
    give(now.chosen, {ImGuiCol_ButtonActive, ImGuiCol_FrameBgActive, ImGuiCol_Header, ImGuiCol_HeaderActive,
                      ImGuiCol_PlotHistogram, ImGuiCol_TextSelectedBg});
    give(now.handle, {ImGuiCol_SliderGrab, ImGuiCol_SliderGrabActive});
    give(now.heading, {ImGuiCol_CheckMark, ImGuiCol_PlotLines, ImGuiCol_NavHighlight});
    give(now.border, {ImGuiCol_Border, ImGuiCol_Separator, ImGuiCol_TableBorderStrong,
                      ImGuiCol_TableBorderLight, ImGuiCol_ScrollbarGrab});
    give({0, 0, 0, 0.45F}, {ImGuiCol_ModalWindowDimBg});
}

float em(float times) {
    return times * ImGui::GetIO().Fonts->ConfigData[0].SizePixels;
}

void set_style(float scale) {
    ImGuiStyle& style = ImGui::GetStyle();
    style.WindowRounding = 0;
    style.FrameRounding = 3;
    style.ScaleAllSizes(scale);
    set_theme("");
    load_font(15 * scale);
}

}  // namespace talus::app
