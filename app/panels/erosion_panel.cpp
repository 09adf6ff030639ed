#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

#include "app/core/erosion_controls.h"
#include "app/panels/panels.h"
#include "app/panels/style.h"

namespace talus::app {
namespace {

std::vector<Operation> as_operations(const std::vector<SetParameter>& changes) {
    return {changes.begin(), changes.end()};
}

std::string explained(const ErosionPreset& preset, bool is_climate) {
    std::string text = preset.help;
    if (is_climate) text += "\nTen times as heavy as in nature, so that one sees it work while one plays.";
    for (const std::string& assignment : preset.assignments) {
        text += '\n';
        text += assignment;
    }
    return text;
}

void choose_preset(PanelContext& context, const char* label, const std::string& widget,
                   const std::vector<ErosionPreset>& presets) {
    const Session& session = context.session;
    const Parameters& parameters = session.simulation().parameters();
    const ErosionPreset* present = present_of(presets, parameters);
    label_before(label);
    const bool open = ImGui::BeginCombo(("##" + widget).c_str(), present ? present->name.c_str() : "Own");
    note_widget(widget);
    if (!open) return;
    close_on_escape();
    for (const ErosionPreset& one : presets) {
        const bool pressed = ImGui::Selectable(one.name.c_str(), &one == present);
        note_widget(widget + "=" + one.name);
        tooltip_of(explained(one, &presets == &climates()));
        if (!pressed) continue;
        context.requests.acts.emplace_back([&one, is_climate = &presets == &climates()](Session& s) {
            s.apply_together(one.name,
                             as_operations(settings_of(one, s.simulation().parameters(), s.grid())));
            // So that a storm passes while one looks.
            if (is_climate) s.view().suggest("time.speed", 20.0);
        });
    }
    ImGui::EndCombo();
}

// What the control's parameters stand at.
std::string standing(const ErosionControl& control, const Session& session) {
    std::string text;
    for (const std::string& name : control.parameters) {
        const Parameter& p = session.declaration(name);
        if (!text.empty()) text += ", ";
        text += label_of(p) + " " + value_text(p, session.value(name));
    }
    return text;
}

// It is set when it is let go: one act of the history.
void draw_control(PanelContext& context, const ErosionControl& control) {
    const Session& session = context.session;
    std::optional<ControlInHand>& held = context.state.control_in_hand;
    const bool is_held = held && held->name == control.name;
    float position = is_held ? held->position
                             : static_cast<float>(position_of(control, session.simulation().parameters()));
    label_before(control.name);
    const std::string word = position < 0.25F ? control.low : position > 0.75F ? control.high : std::string();
    const bool moved = ImGui::SliderFloat(("##" + control.name).c_str(), &position, 0, 1, word.c_str(),
                                          ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_NoInput);
    note_widget(control.name);
    if (moved) held = ControlInHand{control.name, position};
    const bool let_go = ImGui::IsItemDeactivated();
    const bool is_active = ImGui::IsItemActive();
    tooltip_of(fmt::format("From {} to {}. {}", control.low, control.high, control.help));
    coloured_text(theme().faint, standing(control, session));
    // The panel may go while it is held.
    if (is_held && !let_go && !moved && !is_active) held.reset();
    if (!let_go || !is_held) return;
    context.requests.acts.emplace_back([&control, position](Session& s) {
        s.apply_together(fmt::format("{}: {:.0f} %", control.name, 100 * position),
                         as_operations(moved_to(control, position, s.simulation().parameters())));
    });
    held.reset();
}

}  // namespace

void draw_erosion_panel(PanelContext& context) {
    const Session& session = context.session;
    const Simulation& simulation = session.simulation();
    draw_parameters(session, context.requests, {"erosion.on"});
    choose_preset(context, "Climate", "climate", climates());
    choose_preset(context, "Rock", "rock", rocks());
    for (const ErosionControl& control : erosion_controls()) draw_control(context, control);
    const bool is_wet = simulation.terrain().water.has_value() || !simulation.springs().empty() ||
                        simulation.terrain().was_painted(PaintedNumber::rain);
    const std::string why =
        why_nothing_erodes(simulation.parameters(), is_wet, simulation.terrain().painted.has_value());
    if (!why.empty()) coloured_text(theme().warning, why);
    heading("Where");
    draw_parameters(session, context.requests, {"erosion.over"});
    draw_button(context.state, MapDrag::mask, "Draw a rectangle",
                "the next drag over the ground says where water takes and slopes slide");
    ImGui::PushStyleColor(ImGuiCol_Header, ImGui::GetStyleColorVec4(ImGuiCol_Button));
    const bool open = ImGui::CollapsingHeader("Physical numbers");
    ImGui::PopStyleColor();
    note_widget("Physical numbers");
    if (open) {
        std::vector<std::string> names = names_in(session, "erosion");
        std::erase_if(names,
                      [](const std::string& name) { return name == "erosion.on" || name == "erosion.over"; });
        draw_parameters(session, context.requests, names);
    }
    heading("Maps");
    draw_section(session, context.requests, "maps");
}

}  // namespace talus::app
