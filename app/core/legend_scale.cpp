#include "app/core/legend_scale.h"

#include <algorithm>

namespace talus::app {
namespace {

// The number that is to be found; null: the view has none, or somebody set it.
const Parameter* wanted_end(const Parameters& view) {
    const render::ViewNumber* ends = render::scale_end_of(render::view_named(view.choice("render.view")));
    return ends && !view.is_given(ends->parameter->name) ? &*ends->parameter : nullptr;
}

// What the view's values hang on.
render::ViewSettings settings_to_count(const Parameters& view, const Parameters& simulation,
                                       const Parameter& end) {
    const render::ViewSettings all = render::view_settings(view, simulation);
    render::ViewSettings counted;
    counted.view = all.view;
    counted.gravity_m_per_s2 = all.gravity_m_per_s2;
    for (const render::ViewNumber& one : render::view_named(all.view).numbers)
        if (one.parameter && one.parameter->name != end.name)
            counted.numbers[one.parameter->name] = one.in(all);
    return counted;
}

// Where there is nothing yet, the scale is the one that the parameter declares.
void suggest_end(Parameters& view, const Parameter& end, double found) {
    view.suggest(end.name, found > 0 ? Value(std::clamp(found, end.low, end.high)) : end.preset);
}

}  // namespace

void LegendScale::forget() {
    counted_.reset();
    range_.cancel();
}

void LegendScale::unset(const Parameters& view, const std::string& name) {
    if (const Parameter* end = wanted_end(view); end && end->name == name) forget();
}

void LegendScale::follow(Parameters& view, const Simulation& simulation, bool stays) {
    const Parameter* end = wanted_end(view);
    if (!end) return forget();
    Counted now{settings_to_count(view, simulation.parameters(), *end), simulation.terrain().tiles.now()};
    const bool same = counted_ && counted_->settings == now.settings;
    if (const auto found = range_.poll(); found && same) suggest_end(view, *end, *found);
    if (same && (stays || counted_->changes == now.changes)) return;
    range_.cancel();
    // Before it begins: what fails does so once.
    counted_ = std::move(now);
    range_.start(simulation.terrain(), counted_->settings);
}

void suggest_scale_end(Parameters& view, const Parameters& simulation, const Terrain& terrain) {
    const Parameter* end = wanted_end(view);
    if (!end) return;
    render::ViewRange range;
    range.start(terrain, settings_to_count(view, simulation, *end));
    suggest_end(view, *end, range.wait());
}

}  // namespace talus::app
