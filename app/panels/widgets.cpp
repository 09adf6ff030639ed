#include "app/panels/widgets.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

#include "app/panels/panels.h"
#include "app/panels/style.h"
#include "sim/drives.h"

namespace talus::app {
namespace {

// Of ImGui's one context, as everything that it draws.
std::vector<WidgetRect>& rects() {
    static std::vector<WidgetRect> the;
    return the;
}

}  // namespace

void tooltip_of(const std::string& text) {
    if (text.empty() || !ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) return;
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(24 * ImGui::GetFontSize());
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
}

void label_before(const std::string& label) {
    constexpr float share = 0.46F;
    const float room = ImGui::GetContentRegionAvail().x;
    const auto fits = [&](const std::string& some) {
        return ImGui::CalcTextSize(some.c_str()).x <= (share - 0.01F) * room;
    };
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(shortened(label, fits).c_str());
    ImGui::SameLine(share * room);
    ImGui::SetNextItemWidth((1 - share) * room);
}

const std::vector<WidgetRect>& widget_rects() {
    return rects();
}

void begin_widgets() {
    rects().clear();
}

void note_widget(const std::string& name) {
    const ImVec2 low = ImGui::GetItemRectMin();
    const ImVec2 high = ImGui::GetItemRectMax();
    rects().push_back({name, low.x, low.y, high.x, high.y});
}

void* panel_image(const gpu::Texture& texture) {
    // Its OpenGL backend takes the texture's name as a pointer.
    const auto name = static_cast<std::intptr_t>(texture.name());
    // NOLINTNEXTLINE(performance-no-int-to-ptr)
    return reinterpret_cast<void*>(name);
}

bool begin_dialog(const char* title, float width_em, float height_em) {
    const float em = ImGui::GetFontSize();
    const ImVec2 window = ImGui::GetMainViewport()->Size;
    const float margin = em / 2;
    const float height = std::min(height_em * em, window.y - 2 * margin);
    ImGui::OpenPopup(title);
    ImGui::SetNextWindowSize({std::min(width_em * em, window.x - 2 * margin), height});
    ImGui::SetNextWindowSizeConstraints({0, 0}, {window.x - 2 * margin, window.y - 2 * margin});
    ImGui::SetNextWindowPos(ImGui::GetMainViewport()->GetCenter(), ImGuiCond_Always, {0.5F, 0.5F});
    return ImGui::BeginPopupModal(title, nullptr, ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize);
}

void close_on_escape() {
    if (ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape))) ImGui::CloseCurrentPopup();
}

bool button(const std::string& name, const std::string& tooltip, bool enabled) {
    ImGui::BeginDisabled(!enabled);
    const bool pressed = ImGui::Button(name.c_str());
    ImGui::EndDisabled();
    note_widget(name);
    tooltip_of(tooltip);
    return pressed;
}

bool choice_button(const std::string& name, bool chosen, const std::string& tooltip, float width) {
    if (chosen) ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_ButtonActive));
    const bool pressed = ImGui::Button(label_of_name(name).c_str(), {width, 0});
    if (chosen) ImGui::PopStyleColor();
    note_widget(name);
    tooltip_of(tooltip);
    return pressed;
}

bool menu_item(const std::string& name, const char* keys, bool enabled, bool chosen,
               const std::string& label) {
    const bool pressed = ImGui::MenuItem((label.empty() ? name : label).c_str(), keys, chosen, enabled);
    note_widget(name);
    return pressed;
}

bool selectable_text(const std::string& text, bool chosen, int flags) {
    const ImVec2 place = ImGui::GetCursorScreenPos();
    ImGui::PushID(text.c_str());
    const bool pressed = ImGui::Selectable("##text", chosen, flags);
    ImGui::PopID();
    ImGui::GetWindowDrawList()->AddText(place, ImGui::GetColorU32(ImGuiCol_Text), text.c_str());
    return pressed;
}

std::string shortened(const std::string& text, const std::function<bool(const std::string&)>& fits) {
    if (text.empty() || fits(text)) return text;
    const auto follows = [](char byte) { return (static_cast<unsigned char>(byte) & 0xC0U) == 0x80U; };
    std::string shown = text;
    while (!shown.empty() && !fits(shown + "…")) {
        // A letter is its first byte and those that follow it.
        while (shown.size() > 1 && follows(shown.back())) shown.pop_back();
        shown.pop_back();
    }
    return shown + "…";
}

void text_line(const std::string& text) {
    const float room = ImGui::GetContentRegionAvail().x;
    const std::string shown =
        shortened(text, [=](const std::string& some) { return ImGui::CalcTextSize(some.c_str()).x <= room; });
    ImGui::TextUnformatted(shown.c_str());
    if (shown != text) tooltip_of(text);
}

void figure_line(const std::string& name, const std::string& value) {
    ImGui::TextUnformatted(name.c_str());
    ImGui::SameLine(0.5F * ImGui::GetWindowContentRegionMax().x);
    text_line(value);
}

void coloured_text(glm::vec4 colour, const std::string& text) {
    ImGui::PushStyleColor(ImGuiCol_Text, colour_of(colour));
    ImGui::TextWrapped("%s", text.c_str());
    ImGui::PopStyleColor();
}

void heading(const char* text) {
    ImGui::Spacing();
    coloured_text(theme().heading, text);
    ImGui::Separator();
}

void draw_declared(const Session& session, PanelRequests& requests, const Parameter& declared) {
    const std::string& name = declared.name;
    Value value = session.value(name);
    // What waits to be set is shown as if it were.
    if (const auto awaited = requests.parameters.find(name); awaited != requests.parameters.end())
        value = awaited->second.value.value_or(declared.preset);
    switch (draw_parameter(declared, value)) {
        case Edit::set:
            requests.parameters[name] = {value, requests.acts.size()};
            break;
        case Edit::unset:
            if (session.is_given(name))
                requests.parameters[name] = {std::nullopt, requests.acts.size()};
            else
                requests.parameters.erase(name);
            break;
        case Edit::none:
            break;
    }
    if (series_of(session.simulation().drives(), name))
        ImGui::TextDisabled("  follows a table until it is set here");
}

void draw_parameters(const Session& session, PanelRequests& requests, const std::vector<std::string>& names) {
    for (const std::string& name : names) draw_declared(session, requests, session.declaration(name));
}

std::vector<std::string> names_in(const Session& session, const std::string& section) {
    std::vector<std::string> names;
    for (const Parameters* parameters : {&session.simulation().parameters(), &session.view()})
        for (const Parameter& p : parameters->declared())
            if (p.name.starts_with(section + ".")) names.push_back(p.name);
    return names;
}

void draw_section(const Session& session, PanelRequests& requests, const std::string& section) {
    draw_parameters(session, requests, names_in(session, section));
}

void plot_line(const char* label, const std::vector<float>& values, const char* unit) {
    if (values.empty()) return;
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    ImGui::TextWrapped("%s", fmt::format("{} {} {}  ({} to {})", label, figure(values.back(), 4), unit,
                                         figure(*low, 4), figure(*high, 4))
                                 .c_str());
    // A line that does not move lies in the middle, not at an edge.
    const float room = std::max(0.05F * (*high - *low), 1e-6F);
    ImGui::PlotLines(fmt::format("##{}", label).c_str(), values.data(), static_cast<int>(values.size()), 0,
                     nullptr, *low - room, *high + room,
                     {ImGui::GetContentRegionAvail().x, 2.6F * ImGui::GetFontSize()});
}

}  // namespace talus::app
