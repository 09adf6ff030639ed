#pragma once
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "app/core/gauges.h"
#include "app/core/sections.h"
#include "render/camera.h"
#include "sim/parameters.h"

namespace talus::app {

/// A camera to go back to.
struct NamedCamera {
    std::string name;
    render::Camera camera;
    bool operator==(const NamedCamera&) const = default;
};
/// The one of this name. Throws talus::Error that lists the names.
const render::Camera& camera_named(const std::vector<NamedCamera>& cameras, const std::string& name);

/// What a project keeps besides its terrain: how somebody looked at it, and what he put there.
struct Workspace {
    std::vector<std::string> parameters;  ///< of drawing and of the hand, as "section.name=value"
    std::optional<render::Camera> camera;
    std::vector<NamedCamera> cameras;
    std::vector<Gauge> gauges;
    std::vector<double> gauge_times_s;  ///< of the gauges' rows
    std::vector<PlacedSection> sections;
    std::vector<double> section_times_s;
    std::vector<glm::dvec2> path_m;  ///< points of a path that is not built
    std::string panel;               ///< the one that was shown; empty: it is not said
    bool panels_shown = true;
};

/// As documents keep it; numbers keep every bit.
std::string workspace_text(const Workspace& workspace);
/// Throws talus::Error where the text is none of workspace_text()'s.
Workspace workspace_from(const std::string& text);

/// What of it goes on where the terrain went on without a window: what was placed, without rows of a time
/// that is over.
Workspace without_rows(Workspace workspace);

/// The given parameters that a project keeps, as "section.name=value": all but those of the machine.
std::vector<std::string> kept_assignments(const Parameters& view);

}  // namespace talus::app
