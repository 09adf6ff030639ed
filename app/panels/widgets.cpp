#include "app/panels/widgets.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "app/core/icon.h"
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

void begin_tooltip() {
    const ImVec2 window = ImGui::GetMainViewport()->Size;
    const float left = ImGui::GetWindowPos().x;
    const float right = left + ImGui::GetWindowWidth();
    const float edge = em(1);
    const bool low = ImGui::GetItemRectMin().y > 0.6F * window.y;
    const float top = low ? ImGui::GetItemRectMax().y : ImGui::GetItemRectMin().y;
    const float gap = ImGui::GetStyle().WindowPadding.x + 4;
    if (left <= edge && right < 0.5F * window.x)
        ImGui::SetNextWindowPos({right + gap, top}, ImGuiCond_Always, {0, low ? 1.0F : 0.0F});
    else if (right >= window.x - 2 * edge && left > 0.5F * window.x)
        ImGui::SetNextWindowPos({left - gap, top}, ImGuiCond_Always, {1, low ? 1.0F : 0.0F});
    ImGui::BeginTooltip();
}

void tooltip_of(const std::string& text) {
    if (text.empty() || !ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) return;
    begin_tooltip();
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

bool begin_dialog(const char* title, float width_em, float height_em, bool grows) {
    const float em = ImGui::GetFontSize();
    const ImVec2 window = ImGui::GetMainViewport()->Size;
    const float margin = em / 2;
    const float height = std::min(height_em * em, window.y - 2 * margin);
    ImGui::OpenPopup(title);
    ImGui::SetNextWindowSize({std::min(width_em * em, window.x - 2 * margin), height});
    const float top = std::min(3 * em, 0.1F * window.y);
    ImGui::SetNextWindowSizeConstraints({0, 0},
                                        {window.x - 2 * margin, window.y - margin - (grows ? top : margin)});
    if (grows)
        ImGui::SetNextWindowPos({window.x / 2, top}, ImGuiCond_Always, {0.5F, 0});
    else
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

namespace {

// A button that stays down while chosen. `id`: ImGui's, empty: as its label.
bool held_button(const std::string& name, const std::string& tooltip, const IconButton& looks) {
    ImGui::BeginDisabled(!looks.enabled);
    if (looks.chosen) ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_ButtonActive));
    const std::string label = label_of_name(name) + (looks.id.empty() ? "" : "###" + looks.id);
    const bool pressed = ImGui::Button(label.c_str(), {looks.width, 0});
    if (looks.chosen) ImGui::PopStyleColor();
    ImGui::EndDisabled();
    note_widget(name);
    tooltip_of(tooltip);
    return pressed;
}

}  // namespace

bool choice_button(const std::string& name, bool chosen, const std::string& tooltip, float width) {
    return held_button(name, tooltip, {"", width, chosen});
}

bool icon_button(const std::string& name, const std::string& tooltip, const IconButton& looks) {
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    ImGui::PushStyleVar(ImGuiStyleVar_ButtonTextAlign, {0, 0.5F});
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {em(1.6F), ImGui::GetStyle().FramePadding.y});
    const bool pressed = held_button(name, tooltip, looks);
    ImGui::PopStyleVar(2);
    const float side = em(1);
    const ImVec2 first{corner.x + em(0.3F), corner.y + (ImGui::GetItemRectSize().y - side) / 2};
    const ImU32 colour = ImGui::GetColorU32(looks.enabled ? ImGuiCol_Text : ImGuiCol_TextDisabled);
    // Each is read once.
    static std::map<std::string, std::vector<std::vector<glm::vec2>>> icons;
    auto lines = icons.find(looks.icon);
    if (lines == icons.end()) lines = icons.emplace(looks.icon, icon_lines(looks.icon)).first;
    for (const std::vector<glm::vec2>& line : lines->second) {
        for (const glm::vec2& point : line)
            ImGui::GetWindowDrawList()->PathLineTo(
                {first.x + side * point.x / icon_side, first.y + side * point.y / icon_side});
        ImGui::GetWindowDrawList()->PathStroke(colour, 0, em(0.095F));
    }
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

bool number_until_let_go(std::map<std::string, double>& in_hand, const std::string& name,
                         const NumberField& field, double& value) {
    const auto held = in_hand.find(name);
    double shown = held == in_hand.end() ? value : held->second;
    const auto speed = static_cast<float>(
        std::max(std::abs(shown) * 0.005, field.step > 0 ? field.step : (field.high - field.low) * 1e-6));
    ImGui::DragScalar(("##" + name).c_str(), ImGuiDataType_Double, &shown, speed, &field.low, &field.high,
                      field.format, ImGuiSliderFlags_AlwaysClamp);
    note_widget(name);
    if (ImGui::IsItemActive())
        in_hand[name] = shown;
    else
        in_hand.erase(name);
    if (!ImGui::IsItemDeactivatedAfterEdit()) return false;
    // What reads as before is as before: Escape takes back to what was written, which is rounded.
    const auto written = [&](double number) {
        std::array<char, 64> text{};
        std::snprintf(text.data(), text.size(), field.format, number);
        return std::string(text.data());
    };
    if (written(shown) == written(value)) return false;
    value = shown;
    return true;
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
