#pragma once
#include <cstddef>
#include <glm/glm.hpp>
#include <utility>

namespace talus::app {

enum class MarkKind { gauge, spring };

/// One of what stands at a place on the map, and can be moved there.
struct MapMark {
    MarkKind kind = MarkKind::gauge;
    std::size_t index = 0;  ///< among those of its kind
    bool operator==(const MapMark&) const = default;
};

/// The same at a place, m.
struct MovedMark {
    MapMark mark;
    glm::dvec3 place_m{0};
};

/// What a drag over the map can draw: a line, or a rectangle by opposite corners.
enum class MapDrag { section, mask, breach };

/// Where a drag over the ground began and ended.
using Corners = std::pair<glm::dvec3, glm::dvec3>;

/// What was drawn, or is being drawn.
struct DrawnDrag {
    MapDrag what = MapDrag::section;
    Corners corners;
};

/// What the mouse is on, where it stands, and how far from the mouse its foot is in the window, pixels.
struct MarkUnderMouse {
    MovedMark at;
    glm::dvec2 to_foot_px{0};
};

}  // namespace talus::app
