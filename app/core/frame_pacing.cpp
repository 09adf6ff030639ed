#include "app/core/frame_pacing.h"

#include <algorithm>
#include <cmath>

namespace talus::app {
namespace {

constexpr double frame_goal_s = 1.0 / 30;

}  // namespace

void FramePacing::begin(bool moving) {
    if (moving)
        frames_left_ = 2;
    else if (frames_left_ > 0)
        --frames_left_;
}

double FramePacing::picture_scale(bool moving, bool camera_moved) {
    // A camera at rest keeps its size while it can, so that changes redraw only what they touch.
    const double haste = frame_goal_s / std::max(rest_s_ + frame_goal_s / 8, 1e-3);
    if (moving && moved_before_ && (camera_moved || haste < 0.92 || haste > 1.6))
        scale_ = std::clamp(scale_ * std::sqrt(haste), 0.9 * scale_, 1.05 * scale_);
    moved_before_ = moving;
    scale_ = std::clamp(scale_, 0.3, 1.0);
    return moving ? scale_ : 1.0;
}

double FramePacing::ticks_budget_s() const {
    return std::clamp(frame_goal_s - rest_s_, frame_goal_s / 8, frame_goal_s / 2);
}

}  // namespace talus::app
