#pragma once
#include <string>
#include <vector>

#include "sim/parameters.h"
#include "sim/passes/dab.h"
#include "sim/terrain/terrain_state.h"

// What happens by itself at a simulated time: before the first tick that begins at that time or later.
namespace talus {

/// The parameter that an event sets; empty: it is a breach.
std::string parameter_of(const Event& event);
/// The event sets this one instead.
void set_parameter_of(Event& event, const std::string& name);

/// Sorts them by time, and gives assignments the parameters' present names. Throws talus::Error that says
/// which event is wrong and what would be right.
void check_events(const Parameters& parameters, const Grid& grid, std::vector<Event>& events);

/// The cut of a breach so far, `share` 0 to 1 of it: its bottom sinks from the crest, and its width grows.
Dab dab_of(const Breach& breach, double share);
/// The share that is there at a time; it is there for good at 1.
double share_at(const Event& event, double time_s);

/// In a few words, e.g. "600 s: water.boundary.east=wall".
std::string name_of(const Event& event);

/// Events as text, with what is done already; and back. Throws talus::Error where it is none.
std::string to_text(const std::vector<Event>& events);
std::vector<Event> events_from_text(const std::string& text);

}  // namespace talus
