#include "app/panels/style.h"

#include <imgui.h>

#include "app/panels/legend.h"

namespace talus::app {

void set_style(float scale) {
    ImGui::StyleColorsDark();
    ImGuiStyle& style = ImGui::GetStyle();
    style.WindowRounding = 0;
    style.FrameRounding = 3;
    style.WindowBorderSize = 0;
    style.Colors[ImGuiCol_WindowBg] = {0.085F, 0.095F, 0.11F, 0.97F};
    // Nothing shines through a dialog or a list.
    style.Colors[ImGuiCol_PopupBg] = {0.105F, 0.115F, 0.135F, 1};
    style.Colors[ImGuiCol_Button] = {0.20F, 0.24F, 0.30F, 1};
    style.Colors[ImGuiCol_ButtonActive] = {0.16F, 0.45F, 0.75F, 1};
    style.Colors[ImGuiCol_PlotHistogram] = {0.16F, 0.45F, 0.75F, 1};  // white words can be read on it
    style.Colors[ImGuiCol_ModalWindowDimBg] = {0, 0, 0, 0.45F};
    style.ScaleAllSizes(scale);
    load_font(15 * scale);
}

}  // namespace talus::app
