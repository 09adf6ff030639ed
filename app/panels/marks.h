#pragma once
#include <deque>
#include <optional>
#include <utility>

#include "app/core/session.h"
#include "app/panels/panels.h"
#include "render/ground_depth.h"

namespace talus::app {

/// Where gauges and sections stand in the picture, and the line of a ramp or section that is being drawn.
/// Hills in front hide the signs. Of lines they leave a thin one.
class Marks {
  public:
    /// What stands beside the session's own.
    struct Shown {
        std::optional<std::pair<glm::dvec3, glm::dvec3>> section{};  ///< the line of one that is being drawn
        std::optional<std::pair<glm::dvec3, glm::dvec3>>
            mask{};         ///< corners of a rectangle that is being drawn
        bool path = false;  ///< the path, while its panel is open
    };
    /// Over the picture of `drawn` pixels that the window shows in `area`.
    void draw(Session& session, const PictureArea& area, glm::ivec2 drawn, glm::ivec2 window,
              const Shown& shown);

  private:
    void hide_behind(double distance_m);

    render::GroundDepth depth_;
    std::deque<double> distances_m_;  // what the draw list looks at when it is drawn
};

}  // namespace talus::app
