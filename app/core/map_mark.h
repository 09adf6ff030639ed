#pragma once
#include <cstddef>
#include <glm/glm.hpp>

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

/// What the mouse is on, where it stands, and how far from the mouse its foot is in the window, pixels.
struct MarkUnderMouse {
    MovedMark at;
    glm::dvec2 to_foot_px{0};
};

}  // namespace talus::app
