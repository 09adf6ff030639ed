#include "app/core/scene_events.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/core/session.h"
#include "sim/error.h"

namespace talus::app {
namespace {

// A whole second, about a minute from now.
double soon_s(const Session& session) {
    return std::ceil(session.simulation().clock().simulated_s) + 60;
}

std::string history_name(const Session& session, const Event& event) {
    return fmt::format("Event at {:g} s: {}", event.at_s, words_of(session.simulation().parameters(), event));
}

void add(Session& session, Event event) {
    std::vector<Event> events = session.simulation().events();
    const std::string name = history_name(session, event);
    events.push_back(std::move(event));
    session.apply_together(name, {SetEvents{std::move(events)}});
}

// Whether it is the same, whether done by now or not.
bool is_same(const Event& a, const Event& b) {
    return a.at_s == b.at_s && a.assignment == b.assignment && a.breach == b.breach;
}

std::vector<Event>::iterator found_in(std::vector<Event>& events, const Event& event) {
    // One may be done and another like it still to come.
    auto found = std::find(events.begin(), events.end(), event);
    if (found == events.end())
        found =
            std::find_if(events.begin(), events.end(), [&](const Event& one) { return is_same(one, event); });
    if (found == events.end())
        throw Error(fmt::format("the event at {} was changed or taken away meanwhile: look for it again",
                                name_of(event)));
    return found;
}

// The highest ground along the line.
double crest_m(const Session& session, glm::dvec2 from_m, glm::dvec2 to_m) {
    const Terrain& terrain = session.simulation().terrain();
    const Grid& grid = terrain.grid();
    const std::vector<float> ground_m = terrain.ground.read_all<float>();
    const double step_m = 0.5 * std::min(grid.dx, grid.dy);
    const int steps = static_cast<int>(std::ceil(glm::distance(from_m, to_m) / step_m));
    double highest_m = -HUGE_VAL;
    for (int i = 0; i <= steps; ++i) {
        const glm::dvec2 at_m = glm::mix(from_m, to_m, i / std::max<double>(steps, 1));
        const glm::ivec2 sample(std::clamp(std::lround(grid.column_of(at_m.x)), 0L, grid.nx - 1L),
                                std::clamp(std::lround(grid.row_of(at_m.y)), 0L, grid.ny - 1L));
        highest_m =
            std::max<double>(highest_m, ground_m[static_cast<std::size_t>(sample.y) * grid.nx + sample.x]);
    }
    return highest_m;
}

}  // namespace

bool can_be_set_by_event(const Parameter& parameter) {
    return parameter.name != "time.tick_s" && parameter.sets_off != SetsOff::sea;
}

std::string words_of(const Parameters& parameters, const Event& event) {
    if (event.breach)
        return fmt::format("a breach {:.4g} m wide, down to {:.6g} m", event.breach->width_m,
                           event.breach->bottom_m);
    Parameters then = parameters;
    then.set_assignment(event.assignment);
    const Parameter& declared = then.declaration(parameter_of(event));
    return label_of(declared) + ": " + value_text(declared, then.value(declared.name));
}

void add_event(Session& session, const std::string& parameter) {
    const Parameters& all = session.simulation().parameters();
    const Parameter& declared = all.declaration(parameter);
    add(session, {soon_s(session), declared.name + "=" + to_text(all.value(declared.name))});
}

void add_breach(Session& session, glm::dvec3 from_m, glm::dvec3 to_m) {
    const Grid& grid = session.grid();
    const double crest = crest_m(session, from_m, to_m);
    const double bottom = std::min(from_m.z, to_m.z);
    // Roundings of what was clicked are no dam.
    if (!(crest > std::max(from_m.z, to_m.z) + 1e-3 * (1 + std::abs(crest))))
        throw Error(fmt::format(
            "the line from {:.6g},{:.6g} to {:.6g},{:.6g} m crosses no dam: draw it from the water "
            "over the crest to the ground behind it",
            from_m.x, from_m.y, to_m.x, to_m.y));
    Breach breach;
    breach.from_m = glm::dvec2(from_m);
    breach.to_m = glm::dvec2(to_m);
    breach.width_m = std::max(4 * std::max(grid.dx, grid.dy), crest - bottom);
    breach.crest_m = crest;
    breach.bottom_m = bottom;
    breach.over_s = 60;
    add(session, {soon_s(session), "", breach});
}

void change_event(Session& session, const Event& was, const Event& is) {
    std::vector<Event> events = session.simulation().events();
    const auto found = found_in(events, was);
    if (found->done) throw Error(fmt::format("the event at {} has happened: undo leads back", name_of(was)));
    *found = is;
    session.apply_together(history_name(session, is), {SetEvents{std::move(events)}});
}

void remove_event(Session& session, const Event& event) {
    std::vector<Event> events = session.simulation().events();
    events.erase(found_in(events, event));
    session.apply_together("No more: " + history_name(session, event), {SetEvents{std::move(events)}});
}

}  // namespace talus::app
