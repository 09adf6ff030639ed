#pragma once
#include <deque>
#include <optional>
#include <utility>
#include <vector>

#include "app/core/map_mark.h"
#include "app/core/session.h"
#include "app/panels/panels.h"
#include "render/ground_depth.h"

namespace talus::app {

/// Where gauges, springs and sections stand in the picture, and the line of a ramp or section that is being
/// drawn. Hills in front hide the signs. Of lines they leave a thin one.
class Marks {
  public:
    /// What stands beside the session's own.
    struct Shown {
        std::optional<DrawnDrag> drawn{};  ///< what is being drawn
        bool path = false;                 ///< the path, while its panel is open
        bool breaches = false;             ///< the lines of dams that are to break, the same
        std::optional<MovedMark> moved{};  ///< what is being dragged, where it is
    };
    /// Over the picture of `drawn` pixels that the window shows in `area`.
    void draw(Session& session, const PictureArea& area, glm::ivec2 drawn, glm::ivec2 window,
              const Shown& shown);

    /// What has its sign at a place of the window, as they were drawn last, unless a hill in front hides it.
    /// `cursor`: where the mouse's ray meets the ground.
    std::optional<MarkUnderMouse> under(glm::dvec2 mouse, const render::Camera& camera,
                                        const std::optional<glm::dvec3>& cursor) const;

  private:
    // Where a sign can be taken.
    struct Handle {
        MovedMark mark;
        glm::dvec2 at;  // its foot
        double distance_m;
    };

    void hide_behind(double distance_m);

    render::GroundDepth depth_;
    std::vector<Handle> handles_;     // the nearest last
    std::deque<double> distances_m_;  // what the draw list looks at when it is drawn
};

}  // namespace talus::app
