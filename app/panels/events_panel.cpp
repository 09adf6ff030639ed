#include <fmt/format.h>
#include <imgui.h>

#include "app/core/scene_events.h"
#include "app/panels/panels.h"

namespace talus::app {
namespace {

constexpr double most_s = 1e9;

std::string number_name(const Parameter& p) {
    return p.name.substr(0, p.name.find('.')) + ": " + label_of(p);
}

void choose_what_is_set(PanelContext& context) {
    std::string& chosen = context.state.event_sets;
    const Parameters& all = context.session.simulation().parameters();
    ImGui::SetNextItemWidth(-1);
    const bool open = ImGui::BeginCombo("##event sets", number_name(all.declaration(chosen)).c_str(),
                                        ImGuiComboFlags_HeightLarge);
    note_widget("what an event sets");
    if (!open) return;
    close_on_escape();
    for (const Parameter& p : all.declared()) {
        if (!can_be_set_by_event(p)) continue;
        if (ImGui::Selectable(number_name(p).c_str(), p.name == chosen)) chosen = p.name;
        note_widget("event of " + p.name);
        if (p.name == chosen) ImGui::SetItemDefaultFocus();
        tooltip_of(p.help);
    }
    ImGui::EndCombo();
}

bool edit_field(const std::string& label, const std::string& name, double& value, double low, double high,
                const char* format) {
    label_before(label);
    const bool changed = ImGui::DragScalar(("##" + name).c_str(), ImGuiDataType_Double, &value, 0.5F, &low,
                                           &high, format, ImGuiSliderFlags_AlwaysClamp);
    note_widget(name);
    return changed;
}

bool edit_breach(const std::string& name, Breach& breach) {
    ImGui::TextDisabled("%s", fmt::format("from {:.0f}, {:.0f} to {:.0f}, {:.0f} m", breach.from_m.x,
                                          breach.from_m.y, breach.to_m.x, breach.to_m.y)
                                  .c_str());
    bool changed = edit_field("Within", name + " over", breach.over_s, 0, most_s, "%.6g s");
    changed |= edit_field("Width below", name + " width", breach.width_m, 1e-3, 1e6, "%.6g m");
    changed |= edit_field("Crest", name + " crest", breach.crest_m, breach.bottom_m, 1e6, "%.6g m");
    changed |= edit_field("Bottom", name + " bottom", breach.bottom_m, -1e6, breach.crest_m, "%.6g m");
    changed |= edit_field("Sides, rise by run", name + " sides", breach.side_slope, 1e-3, 1e6, "%.4g");
    return changed;
}

bool edit_assignment(const Parameters& parameters, Event& event) {
    Parameters then = parameters;
    then.set_assignment(event.assignment);
    const Parameter& declared = then.declaration(parameter_of(event));
    Value value = then.value(declared.name);
    if (draw_parameter(declared, value) != Edit::set) return false;
    event.assignment = declared.name + "=" + to_text(value);
    return true;
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
    // What is dragged or typed is an act once it is let go.
    auto& in_hand = context.state.event_in_hand;
    const bool is_held = in_hand && in_hand->was == event;
    Event shown = is_held ? in_hand->is : event;
    bool changed = edit_field("At", name + " at", shown.at_s, 0, most_s, "%.6g s");
    changed |= shown.breach ? edit_breach(name, *shown.breach)
                            : edit_assignment(session.simulation().parameters(), shown);
    if (changed) in_hand = EventInHand{event, shown};
    if (!(in_hand && in_hand->was == event) || ImGui::IsAnyItemActive()) return;
    const EventInHand done = *std::exchange(in_hand, std::nullopt);
    if (done.is != done.was)
        context.requests.acts.emplace_back([done](Session& s) { change_event(s, done.was, done.is); });
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
