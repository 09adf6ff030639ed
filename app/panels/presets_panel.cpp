#include <fmt/format.h>
#include <imgui.h>

#include <cmath>

#include "app/panels/panels.h"
#include "sim/gpu/embedded_text.h"
#include "sim/io/colour_image.h"
#include "sim/preset.h"

namespace talus::app {
namespace {

// The preset's picture; an empty texture where it has none.
const gpu::Texture& thumbnail(PanelState& state, const std::string& preset) {
    const auto found = state.thumbnails.find(preset);
    if (found != state.thumbnails.end()) return found->second;
    gpu::Texture& texture = state.thumbnails[preset];
    const auto picture = embedded_presets().find(preset + ".png");
    if (picture == embedded_presets().end()) return texture;
    const io::ColourImage image = io::decode_png(picture->second, preset);
    texture = gpu::Texture("thumbnail", gpu::Format::rgba8, image.width, image.height);
    texture.write(texture.whole(), std::as_bytes(std::span(image.rgba)));
    return texture;
}

}  // namespace

void draw_preset_grid(PanelContext& context) {
    static const std::vector<Preset> presets = built_in_presets();
    const float spacing = ImGui::GetStyle().ItemSpacing.x;
    const float wish = 9 * ImGui::GetFontSize();
    const float room = ImGui::GetContentRegionAvail().x;
    const int columns = std::max(1, static_cast<int>(std::floor((room + spacing) / (wish + spacing))));
    const float width = (room - spacing * static_cast<float>(columns - 1)) / static_cast<float>(columns);
    int column = 0;
    for (const Preset& preset : presets) {
        ImGui::PushID(preset.name.c_str());
        ImGui::BeginGroup();
        const gpu::Texture& picture = thumbnail(context.state, preset.name);
        const ImVec2 size{width - 2 * ImGui::GetStyle().FramePadding.x, width * 9 / 16};
        const bool pressed = picture.width() > 0 ? ImGui::ImageButton(panel_image(picture), size)
                                                 : ImGui::Button(preset.name.c_str(), size);
        note_widget("preset " + preset.name);
        tooltip_of(preset.description);
        ImGui::TextUnformatted(preset.title.c_str());
        ImGui::EndGroup();
        ImGui::PopID();
        if (pressed) {
            SceneRequest request;
            request.preset = preset.name;
            context.requests.open = request;
            context.state.start_page = false;
        }
        if (++column % columns != 0) ImGui::SameLine();
    }
    ImGui::NewLine();
}

void draw_presets_panel(PanelContext& context) {
    if (button("New terrain…", "of a kind, size and relief of your own")) context.state.fresh.begin();
    draw_preset_grid(context);
}

}  // namespace talus::app
