#include "app/core/place_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace talus::app {

std::string file_coordinates_text(const Session& session, glm::dvec2 place_m) {
    const std::optional<Georeference> on_earth = session.georeference();
    if (!on_earth) return "";
    const glm::dvec2 place = coordinates_of(*on_earth, session.grid(), place_m);
    // Degrees need more digits than metres.
    const double step = std::abs(on_earth->transform[1]);
    const int digits = std::clamp(static_cast<int>(std::ceil(1 - std::log10(std::max(step, 1e-9)))), 1, 9);
    return fmt::format("{:.{}f}, {:.{}f}", place.x, digits, place.y, digits);
}

}  // namespace talus::app
