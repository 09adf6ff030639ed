#include <fmt/format.h>
#include <imgui.h>

#include <cmath>

#include "app/panels/panels.h"

namespace talus {
namespace {

std::string label_of(const Parameter& p) {
    std::string label = p.name.substr(p.name.find('.') + 1);
    // The unit stands behind the value, so it need not stand in the label too.
    for (const char* suffix : {"_m2_per_s", "_m_per_s", "_per_s", "_deg", "_mib", "_m", "_s"})
        if (label.ends_with(suffix)) {
            label.resize(label.size() - std::string(suffix).size());
            break;
        }
    for (char& c : label)
        if (c == '_') c = ' ';
    return label + "##" + p.name;
}

bool edit_number(const Parameter& p, double& real) {
    const double low = p.low;
    const double high = p.high;
    const bool wide = high / std::max(std::abs(low), 1e-9) > 1e4 || (low == 0 && high > 1e3);
    const std::string format = "%.4g " + p.unit;
    if (wide) {
        const auto speed = static_cast<float>(std::max(std::abs(real) * 0.01, 1e-4));
        return ImGui::DragScalar(label_of(p).c_str(), ImGuiDataType_Double, &real, speed, &low, &high,
                                 format.c_str(), ImGuiSliderFlags_AlwaysClamp);
    }
    return ImGui::SliderScalar(label_of(p).c_str(), ImGuiDataType_Double, &real, &low, &high, format.c_str(),
                               ImGuiSliderFlags_AlwaysClamp);
}

}  // namespace

bool draw_parameter(const Parameter& p, Value& value) {
    bool changed = false;
    if (auto* on = std::get_if<bool>(&value)) {
        changed = ImGui::Checkbox(label_of(p).c_str(), on);
    } else if (auto* count = std::get_if<int>(&value)) {
        const int low = static_cast<int>(p.low);
        const int high = static_cast<int>(p.high);
        changed = ImGui::DragScalar(label_of(p).c_str(), ImGuiDataType_S32, count, 1, &low, &high, "%d",
                                    ImGuiSliderFlags_AlwaysClamp);
    } else if (auto* real = std::get_if<double>(&value)) {
        changed = edit_number(p, *real);
    } else {
        auto& name = std::get<std::string>(value);
        if (ImGui::BeginCombo(label_of(p).c_str(), name.c_str())) {
            for (const std::string& choice : p.choices)
                if (ImGui::Selectable(choice.c_str(), choice == name)) {
                    name = choice;
                    changed = true;
                }
            ImGui::EndCombo();
        }
    }
    if (ImGui::IsItemHovered()) {
        const std::string range =
            std::holds_alternative<double>(p.preset) || std::holds_alternative<int>(p.preset)
                ? fmt::format("\n{:.6g} to {:.6g} {}", p.low, p.high, p.unit)
                : "";
        ImGui::SetTooltip("%s\n%s%s\ndefault %s: right click", p.name.c_str(), p.help.c_str(), range.c_str(),
                          to_text(p.preset).c_str());
    }
    if (ImGui::IsItemClicked(ImGuiMouseButton_Right)) {
        value = p.preset;
        changed = true;
    }
    return changed;
}

}  // namespace talus
