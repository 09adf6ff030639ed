#pragma once
#include <string>

#include "app/core/session.h"

namespace talus::app {

/// A place on the map (m) in the coordinates of the terrain's file, with as many digits as a tenth of a
/// sample needs; empty: the terrain does not say where it lies.
std::string file_coordinates_text(const Session& session, glm::dvec2 place_m);

}  // namespace talus::app
