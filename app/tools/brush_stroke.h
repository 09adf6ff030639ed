#pragma once
#include <glm/glm.hpp>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "app/tools/tools.h"
#include "sim/parameters.h"
#include "sim/passes/dab.h"
#include "sim/terrain/stamp.h"

namespace talus::app {

/// What keys that are held make of a tool.
struct Modifiers {
    bool inverted = false;  ///< Ctrl: takes where it adds, wipes where it paints
    bool smooth = false;    ///< Shift: smooths, whatever the tool
};

/// The dab that the tool makes in the middle of its brush, as the parameters say: of `wall_s` seconds of wall
/// time, or of its whole effect where it does not work by time (ramp, stamp). `ground_m`: the height where
/// the stroke began.
Dab tool_dab(const Parameters& view, const Modifiers& modifiers, double ground_m, double wall_s,
             const Stamp* stamp);

/// One stroke of a hand: where it was led, turned into dabs a set part of the radius apart that share its
/// wall time, so that its strength does not depend on how many frames it took.
class BrushStroke {
  public:
    /// `number` counts strokes: each has jitter of its own, the same for the same brush.seed.
    BrushStroke(const Parameters& view, const Modifiers& modifiers, glm::dvec3 at, unsigned number);

    /// What to call the stroke in a history.
    const std::string& name() const { return name_; }
    /// The dabs of having come here within this much wall time.
    std::vector<Dab> move(const Parameters& view, glm::dvec3 at, double wall_s, const Stamp* stamp);
    /// The dab that is made when the hand lets go: of a ramp, from where it began; of erosion, which lets
    /// settle what its water carries.
    std::optional<Dab> end(const Parameters& view);
    glm::dvec3 begin() const { return begin_; }
    glm::dvec3 at() const { return at_; }

  private:
    /// The parameters of the stroke: the present ones with the tool that it began with. Erosion keeps all
    /// that it began with, because its water has one strength and one size.
    const Parameters& settings(const Parameters& view);
    Dab jittered(const Parameters& view, Dab dab, glm::dvec2 place);
    double unit();

    Modifiers modifiers_;
    const Tool* tool_;
    std::optional<Parameters> held_;
    std::string name_;
    glm::dvec3 begin_;
    glm::dvec3 at_;
    bool begun_ = false;                 // a dab was made that goes by time
    std::optional<glm::dvec2> stamped_;  // where the last stamp was pressed
    std::mt19937 random_;
};

}  // namespace talus::app
