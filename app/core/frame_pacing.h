#pragma once

namespace talus::app {

/// When the window draws, how large the picture is while something moves, and what ticks get of a frame.
/// Knows no window.
class FramePacing {
  public:
    /// Something may have changed: the next few frames are drawn.
    void wake() { frames_left_ = 3; }
    /// Whether frames are drawn though nothing moves.
    bool is_awake() const { return frames_left_ > 0; }
    /// A frame begins; `moving`: something goes on that the next frames show.
    void begin(bool moving);

    /// The picture's sides against the window's: while something moves they give way so that frames keep
    /// coming; at rest 1.
    double picture_scale(bool moving, bool camera_moved);
    /// Whether moving frames are late enough to leave out what is costly.
    bool is_late() const { return scale_ < 0.6; }
    /// What the rest of a frame leaves of its goal, s: an eighth of that at least and half at most.
    double ticks_budget_s() const;
    /// A frame took this long without its ticks, s.
    void took(double rest_s) { rest_s_ += 0.2 * (rest_s - rest_s_); }

  private:
    int frames_left_ = 3;
    double rest_s_ = 1.0 / 60;  // lately
    double scale_ = 1;
    bool moved_before_ = false;
};

}  // namespace talus::app
