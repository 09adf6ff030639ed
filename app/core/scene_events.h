#pragma once
#include <glm/glm.hpp>

#include "sim/events.h"

namespace talus::app {

class Session;

// What happens by itself (sim/events.h), changed by hand as acts, while play goes on.

/// Whether an event can set it.
bool can_be_set_by_event(const Parameter& parameter);

/// What it does, as a person reads it: "Rain: 400 mm/h".
std::string words_of(const Parameters& parameters, const Event& event);

/// The parameter is set to what it is now, a minute from now: to be changed to what it shall be. Throws
/// talus::Error where no event can set it.
void add_event(Session& session, const std::string& parameter);
/// A dam breaks along a line between two points of the ground, a minute from now and within a minute: from
/// the highest ground on that line down to the lower end. Throws talus::Error where the line crosses no
/// higher ground. Waits for the device.
void add_breach(Session& session, glm::dvec3 from_m, glm::dvec3 to_m);
/// One of them becomes another. Throws talus::Error where `was` is not there any more, or it cannot be so.
void change_event(Session& session, const Event& was, const Event& is);
void remove_event(Session& session, const Event& event);

}  // namespace talus::app
