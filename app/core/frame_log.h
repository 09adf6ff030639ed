#pragma once
#include <string>
#include <vector>

namespace talus::app {

/// What the window's frames took, in the order of their parts, milliseconds of wall time.
struct FrameTimes {
    double at_s = 0;     ///< since the window opened, when the frame began
    double act_ms = 0;   ///< the hand: dabs of a stroke, the camera
    double play_ms = 0;  ///< ticks
    double picture_ms = 0;
    double panels_ms = 0;
    double present_ms = 0;
    int dabs = 0;          ///< made in this frame: their picture is in it
    double waited_ms = 0;  ///< how old the oldest movement in them was when the frame began
    double scale = 1;      ///< of the picture's sides against the window's
    double total_ms() const { return act_ms + play_ms + picture_ms + panels_ms + present_ms; }
};

/// A table of frames as CSV, a row each.
std::string to_csv(const std::vector<FrameTimes>& frames);

}  // namespace talus::app
