#pragma once
#include <optional>

#include "app/tools/brush_stroke.h"
#include "render/ring.h"
#include "sim/passes/stamp_image.h"
#include "sim/simulation.h"

namespace talus::app {

/// The hand's strokes as acts of a simulation. Within a tick dabs wait for its end, so that a frame need not.
class Sculpting {
  public:
    void begin(const Parameters& view, glm::dvec3 at, const Modifiers& modifiers);
    /// The hand is at a place on the ground after this much wall time.
    void move(Simulation& simulation, const Parameters& view, glm::dvec3 at, double wall_s);
    /// Ends the stroke; runs a tick that goes on to its end first.
    void end(Simulation& simulation, const Parameters& view);
    /// None is going on: what was begun was of another terrain.
    void forget() { stroke_.reset(); }

    /// The stroke that is being made; none: none is.
    const std::optional<BrushStroke>& stroke() const { return stroke_; }
    /// Dabs that strokes made so far, and the wall time that the newest had waited for since the ones before.
    int dabs() const { return dabs_; }
    double dabs_waited_s() const { return dabs_waited_s_; }
    /// What the brush shows of itself at a place.
    render::Ring ring(const Simulation& simulation, const Parameters& view, glm::dvec2 at_m);

  private:
    std::optional<BrushStroke> stroke_;
    StampImage stamp_image_;  // of the ring
    unsigned strokes_ = 0;
    double owed_s_ = 0;   // wall time of the stroke that made no dabs yet
    bool begun_ = false;  // as an entry of undo
    int dabs_ = 0;
    double dabs_waited_s_ = 0;
};

}  // namespace talus::app
