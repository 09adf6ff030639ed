#pragma once
#include <deque>

#include "app/core/session.h"
#include "app/panels/panels.h"
#include "render/ground_depth.h"

namespace talus::app {

/// Where gauges stand in the picture, and the line of a ramp that is being drawn. Hills in front hide the
/// signs of gauges. Of a ramp's line they leave a thin one.
class Marks {
  public:
    /// Over the picture of `drawn` pixels that the window shows in `area`.
    void draw(Session& session, const PictureArea& area, glm::ivec2 drawn, glm::ivec2 window);

  private:
    void hide_behind(double distance_m);

    render::GroundDepth depth_;
    std::deque<double> distances_m_;  // what the draw list looks at when it is drawn
};

}  // namespace talus::app
