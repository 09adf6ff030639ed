#include <fmt/format.h>
#include <imgui.h>

#include "app/core/scene_events.h"
#include "app/panels/panels.h"

namespace talus::app {
namespace {

constexpr double most_s = 1e9;

void choose_what_is_set(PanelContext& context) {
    std::string& chosen = context.state.event_sets;
    const Parameters& all = context.session.simulation().parameters();
    ImGui::SetNextItemWidth(-1);
    const bool open = ImGui::BeginCombo("##event sets", shown_name(all.declaration(chosen)).c_str(),
                                        ImGuiComboFlags_HeightLarge);
    note_widget("what an event sets");
    if (!open) return;
    close_on_escape();
    for (const Parameter& p : all.declared()) {
        if (!can_be_set_by_event(p)) continue;
        if (ImGui::Selectable(shown_name(p).c_str(), p.name == chosen)) chosen = p.name;
        note_widget("event of " + p.name);
        if (p.name == chosen) ImGui::SetItemDefaultFocus();
        tooltip_of(p.help);
    }
    ImGui::EndCombo();
}

// A number with its name before it; true once it was let go with another value.
bool edit_field(PanelContext& context, const std::string& label, const std::string& name,
                const NumberField& field, double& value) {
    label_before(label);
    return number_until_let_go(context.state.numbers_in_hand, name, field, value);
}

bool edit_breach(PanelContext& context, const std::string& name, Breach& breach) {
    ImGui::TextDisabled("%s", fmt::format("from {:.0f}, {:.0f} to {:.0f}, {:.0f} m", breach.from_m.x,
                                          breach.from_m.y, breach.to_m.x, breach.to_m.y)
                                  .c_str());
    const auto edit = [&](const char* label, const char* what, const NumberField& field, double& value) {
        return edit_field(context, label, name + what, field, value);
    };
    bool changed = edit("Within", " over", {"%.6g s", 0, most_s, 0.5}, breach.over_s);
    changed |= edit("Width below", " width", {"%.6g m", 1e-3, 1e6, 0.1}, breach.width_m);
    changed |= edit("Crest", " crest", {"%.6g m", breach.bottom_m, 1e6, 0.1}, breach.crest_m);
    changed |= edit("Bottom", " bottom", {"%.6g m", -1e6, breach.crest_m, 0.1}, breach.bottom_m);
    changed |= edit("Sides, rise by run", " sides", {"%.4g", 1e-3, 1e6, 0.01}, breach.side_slope);
    return changed;
}

bool edit_assignment(PanelContext& context, const std::string& name, Event& event) {
    Parameters then = context.session.simulation().parameters();
    then.set_assignment(event.assignment);
    const Parameter& declared = then.declaration(parameter_of(event));
    Value value = then.value(declared.name);
    bool changed = false;
    if (auto* const real = std::get_if<double>(&value)) {
        const std::string format = "%.6g " + unit_in_format(declared);
        changed = edit_field(context, label_of(declared), name + " value",
                             {format.c_str(), declared.low, declared.high}, *real);
    } else {
        changed = draw_parameter(declared, value) == Edit::set;
    }
    if (changed) event.assignment = declared.name + "=" + to_text(value);
    return changed;
}

void draw_event(PanelContext& context, const Event& event, std::size_t number) {
    const Session& session = context.session;
    const std::string name = fmt::format("event {}", number);
    ImGui::Separator();
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(fmt::format("Event {}{}", number, event.done ? ", done" : "").c_str());
    ImGui::SameLine();
    const bool removed = ImGui::SmallButton("remove");
    note_widget("remove " + name);
    if (removed) context.requests.acts.emplace_back([event](Session& s) { remove_event(s, event); });
    if (event.done) {
        ImGui::TextWrapped(
            "%s", fmt::format("{:.6g} s: {}", event.at_s, words_of(session.simulation().parameters(), event))
                      .c_str());
        return;
    }
    Event wanted = event;
    bool changed = edit_field(context, "At", name + " at", {"%.6g s", 0, most_s, 0.5}, wanted.at_s);
    changed |=
        wanted.breach ? edit_breach(context, name, *wanted.breach) : edit_assignment(context, name, wanted);
    if (changed)
        context.requests.acts.emplace_back([event, wanted](Session& s) { change_event(s, event, wanted); });
}

}  // namespace

void draw_events(PanelContext& context) {
    heading("Events");
    ImGui::TextWrapped("When its time comes, a number is set or a dam breaks by itself.");
    choose_what_is_set(context);
    if (button("Add an event", "it sets what is chosen above; when, and to what, is set below"))
        context.requests.acts.emplace_back(
            [sets = context.state.event_sets](Session& s) { add_event(s, sets); });
    ImGui::SameLine();
    draw_button(context.state, MapDrag::breach, "Draw a breach",
                "the next drag over the ground is the line along which a dam breaks: from the water over its "
                "crest to the ground behind it");
    const std::vector<Event>& events = context.session.simulation().events();
    for (std::size_t i = 0; i < events.size(); ++i) {
        ImGui::PushID(static_cast<int>(i));
        draw_event(context, events[i], i + 1);
        ImGui::PopID();
    }
}

}  // namespace talus::app
