#pragma once
#include <cstdint>
#include <optional>
#include <string>

#include "render/view_range.h"
#include "sim/simulation.h"

namespace talus::app {

/// Ends of scales that follow what the terrain holds (render/view_range.h), as suggestions for the parameters
/// that nobody set: so legends, fields and pictures show the same.
class LegendScale {
  public:
    /// Once a frame. A scale that is shown gets its end when it is shown first, and after every change of the
    /// terrain; while it `stays`, because anything moves, no change moves it.
    void follow(Parameters& view, const Simulation& simulation, bool stays);
    /// True while the device is at it.
    bool pending() const { return range_.pending(); }
    /// What was found holds no more: it is another terrain.
    void forget();
    /// Nobody sets this parameter any more: where it ends the scale that is shown, its end is found at once.
    void unset(const Parameters& view, const std::string& name);

  private:
    // What was counted.
    struct Counted {
        render::ViewSettings settings;  ///< but for the scale's end
        std::uint64_t changes = 0;      ///< of the terrain
    };

    render::ViewRange range_;
    std::optional<Counted> counted_;
};

/// The same at once, for a picture for a file. Waits for the device.
void suggest_scale_end(Parameters& view, const Parameters& simulation, const Terrain& terrain);

}  // namespace talus::app
