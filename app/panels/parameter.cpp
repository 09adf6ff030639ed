#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "app/panels/widgets.h"

namespace talus::app {
std::string shown_name(const Parameter& p) {
    return p.name.substr(0, p.name.find('.')) + ": " + label_of(p);
}

std::string unit_in_format(const Parameter& p) {
    std::string unit;
    for (const char letter : p.unit) unit += letter == '%' ? "%%" : std::string(1, letter);
    return unit;
}

namespace {

bool edit_number(const Parameter& p, const char* id, double& real) {
    const double low = p.low;
    const double high = p.high;
    const bool wide = high / std::max(std::abs(low), 1e-9) > 1e4 || high - low > 1e3;
    // A number with an exponent is hard to read: from a thousand on it is whole.
    const std::string format = (std::abs(real) >= 1000 ? "%.0f " : "%.4g ") + unit_in_format(p);
    if (wide) {
        const auto speed = static_cast<float>(std::max(std::abs(real) * 0.01, 1e-4));
        return ImGui::DragScalar(id, ImGuiDataType_Double, &real, speed, &low, &high, format.c_str(),
                                 ImGuiSliderFlags_AlwaysClamp);
    }
    return ImGui::SliderScalar(id, ImGuiDataType_Double, &real, &low, &high, format.c_str(),
                               ImGuiSliderFlags_AlwaysClamp);
}

bool edit(const Parameter& p, const char* id, Value& value) {
    if (auto* on = std::get_if<bool>(&value)) return ImGui::Checkbox(id, on);
    if (auto* count = std::get_if<int>(&value)) {
        const int low = static_cast<int>(p.low);
        const int high = static_cast<int>(p.high);
        const std::string format = "%d " + unit_in_format(p);
        return ImGui::DragScalar(id, ImGuiDataType_S32, count, 0.2F, &low, &high, format.c_str(),
                                 ImGuiSliderFlags_AlwaysClamp);
    }
    if (auto* real = std::get_if<double>(&value)) return edit_number(p, id, *real);
    auto& name = std::get<std::string>(value);
    bool changed = false;
    if (ImGui::BeginCombo(id, label_of_choice(p, name).c_str())) {
        close_on_escape();
        for (const std::string& choice : p.choices) {
            if (ImGui::Selectable(label_of_choice(p, choice).c_str(), choice == name)) {
                name = choice;
                changed = true;
            }
            note_widget(p.name + "=" + choice);
        }
        ImGui::EndCombo();
    }
    return changed;
}

void explain(const Parameter& p) {
    const bool ranged = std::holds_alternative<double>(p.preset) || std::holds_alternative<int>(p.preset);
    begin_tooltip();
    ImGui::PushTextWrapPos(26 * ImGui::GetFontSize());
    ImGui::TextDisabled("%s", p.name.c_str());
    ImGui::TextUnformatted(p.help.c_str());
    if (ranged)
        ImGui::TextUnformatted(
            fmt::format("{} to {} {}", figure(p.low, 6), figure(p.high, 6), p.unit).c_str());
    ImGui::TextDisabled("%s", fmt::format("default {}; a right click unsets it{}", value_text(p, p.preset),
                                          ranged ? "; a click, on a slider Ctrl+click: an exact value" : "")
                                  .c_str());
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
}

}  // namespace

Edit draw_parameter(const Parameter& p, Value& value) {
    ImGui::PushID(p.name.c_str());
    ImGui::BeginGroup();
    label_before(label_of(p));
    Edit done = edit(p, "##value", value) ? Edit::set : Edit::none;
    note_widget(p.name);
    ImGui::EndGroup();
    if (ImGui::IsItemHovered()) explain(p);
    if (ImGui::IsItemClicked(ImGuiMouseButton_Right)) done = Edit::unset;
    ImGui::PopID();
    return done;
}

}  // namespace talus::app
