#include "sim/events.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "sim/error.h"

namespace talus {
namespace {

using nlohmann::json;

// Throws what is wrong with a breach.
void check_breach(const Grid& grid, const Breach& breach) {
    for (const glm::dvec2 end : {breach.from_m, breach.to_m})
        if (!is_on_map(grid, end))
            throw Error(
                fmt::format("its breach's end {},{} m lies off the map, it must lie within 0,0 and {},{} m",
                            end.x, end.y, grid.width_m(), grid.height_m()));
    const auto check = [](const char* name, double value, double low, double high) {
        if (!(value >= low && value <= high))
            throw Error(
                fmt::format("its breach's {} cannot be {}, it must be {} to {}", name, value, low, high));
    };
    check("width_m", breach.width_m, 1e-3, 1e6);
    check("crest_m", breach.crest_m, -1e6, 1e6);
    check("bottom_m", breach.bottom_m, -1e6, breach.crest_m);
    check("side_slope", breach.side_slope, 1e-3, 1e6);
    check("over_s", breach.over_s, 0, 1e9);
}

void check_event(const Parameters& parameters, const Grid& grid, Event& event) {
    if (!(event.at_s >= 0 && event.at_s <= 1e15))
        throw Error(fmt::format("its at_s cannot be {}, it must be 0 or more seconds", event.at_s));
    if (event.breach) return check_breach(grid, *event.breach);
    Parameters changed = parameters;
    changed.set_assignment(event.assignment);
    const Parameter& declared = changed.declaration(parameter_of(event));
    if (declared.name == "time.tick_s") throw Error("it sets time.tick_s, which holds for a whole run");
    if (declared.sets_off == SetsOff::sea)
        throw Error(fmt::format("it sets {}, which no event can: let it follow a table", declared.name));
    event.assignment = fmt::format("{}={}", declared.name, to_text(changed.value(declared.name)));
}

json json_of(const Event& event) {
    json line = {{"at_s", event.at_s}};
    if (event.done) line["done"] = true;
    if (!event.breach) {
        line["set"] = event.assignment;
        return line;
    }
    const Breach& breach = *event.breach;
    line["breach"] = {{"from_m", {breach.from_m.x, breach.from_m.y}},
                      {"to_m", {breach.to_m.x, breach.to_m.y}},
                      {"width_m", breach.width_m},
                      {"crest_m", breach.crest_m},
                      {"bottom_m", breach.bottom_m},
                      {"side_slope", breach.side_slope},
                      {"over_s", breach.over_s}};
    return line;
}

Event event_of(const json& line) {
    Event event;
    event.at_s = line.at("at_s");
    event.done = line.value("done", false);
    if (!line.contains("breach")) {
        event.assignment = line.at("set");
        return event;
    }
    const json& told = line.at("breach");
    Breach& breach = event.breach.emplace();
    breach.from_m = {told.at("from_m").at(0), told.at("from_m").at(1)};
    breach.to_m = {told.at("to_m").at(0), told.at("to_m").at(1)};
    breach.width_m = told.at("width_m");
    breach.crest_m = told.at("crest_m");
    breach.bottom_m = told.at("bottom_m");
    breach.side_slope = told.at("side_slope");
    breach.over_s = told.at("over_s");
    return event;
}

}  // namespace

std::string parameter_of(const Event& event) {
    return event.assignment.substr(0, event.assignment.find('='));
}

void set_parameter_of(Event& event, const std::string& name) {
    event.assignment.replace(0, parameter_of(event).size(), name);
}

void check_events(const Parameters& parameters, const Grid& grid, std::vector<Event>& events) {
    std::stable_sort(events.begin(), events.end(),
                     [](const Event& a, const Event& b) { return a.at_s < b.at_s; });
    for (Event& event : events) try {
            check_event(parameters, grid, event);
        } catch (const Error& error) {
            throw Error(fmt::format("the event at {} s is wrong: {}", event.at_s, error.what()));
        }
}

double share_at(const Event& event, double time_s) {
    const double over_s = event.breach ? event.breach->over_s : 0;
    return over_s > 0 ? std::clamp((time_s - event.at_s) / over_s, 0.0, 1.0) : 1.0;
}

Dab dab_of(const Breach& breach, double share) {
    const double bottom_m = breach.crest_m + share * (breach.bottom_m - breach.crest_m);
    PathDab path;
    path.kind = PathKind::breach;
    path.points_m = {{breach.from_m, bottom_m}, {breach.to_m, bottom_m}};
    path.half_width_m = share * breach.width_m / 2;
    path.cut_slope = breach.side_slope;
    path.fills = false;
    Dab dab;
    dab.effect = path;
    dab.x_m = breach.from_m.x;
    dab.y_m = breach.from_m.y;
    dab.target_m = bottom_m;
    // Its sides end at the crest.
    dab.radius_m = path.half_width_m + (breach.crest_m - bottom_m) / breach.side_slope + 1e-6;
    return dab;
}

std::string name_of(const Event& event) {
    if (!event.breach) return fmt::format("{} s: {}", event.at_s, event.assignment);
    return fmt::format("{} s: a breach of {} m, down to {} m", event.at_s, event.breach->width_m,
                       event.breach->bottom_m);
}

std::string to_text(const std::vector<Event>& events) {
    if (events.empty()) return "";
    json all = json::array();
    for (const Event& event : events) all.push_back(json_of(event));
    return all.dump();
}

std::vector<Event> events_from_text(const std::string& text) {
    std::vector<Event> events;
    if (text.empty()) return events;
    try {
        for (const json& line : json::parse(text)) events.push_back(event_of(line));
    } catch (const json::exception& error) {
        throw Error(fmt::format("its events cannot be read: {}", error.what()));
    }
    return events;
}

}  // namespace talus
