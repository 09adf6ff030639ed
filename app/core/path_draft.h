#pragma once
#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <vector>

#include "app/core/path_design.h"
#include "sim/simulation.h"

namespace talus::app {

/// A path that is being drawn: points that a hand puts, moves and takes away, until it is built.
class PathDraft {
  public:
    const std::vector<glm::dvec2>& points_m() const { return points_m_; }
    /// After it was built, the first point of another one.
    void add(glm::dvec2 point_m);
    void move(std::size_t index, glm::dvec2 point_m);
    void remove_last();
    void clear() { points_m_.clear(); }
    /// Points that were kept, of a path that is not built.
    void take_up(const std::vector<glm::dvec2>& points_m) {
        clear();
        for (const glm::dvec2 point_m : points_m) add(point_m);
    }
    /// Its last point becomes its first.
    void turn_round();
    /// It is built. Its points stay, for another try after undo.
    void set_built(const Simulation& simulation) {
        built_revision_ = simulation.journal().revision();
        operations_when_built_ = simulation.journal().operations().size();
    }
    /// Whether they were built, and that was not taken back.
    bool is_in_ground(const Simulation& simulation) const {
        return built_revision_ && simulation.journal().operations().size() >= operations_when_built_;
    }
    /// Whether that was the last act.
    bool is_built(const Simulation& simulation) const {
        return built_revision_ == simulation.journal().revision();
    }
    /// The point nearest to a place, at most so far away.
    std::optional<std::size_t> point_near(glm::dvec2 place_m, double reach_m) const;

    /// Designs it anew where points, wishes or ground have changed. The ground is read back only where it has
    /// changed: waits for the device then. `may_read`: false while it changes from frame to frame.
    void follow(const Simulation& simulation, const Parameters& view, bool may_read);
    /// None: it has less than two points.
    const std::optional<PathDesign>& design() const { return design_; }
    /// Heights of the ground at the points.
    const std::vector<double>& heights_m() const { return heights_m_; }
    /// The dab that builds it on the ground as it is now; none: there is no design. Waits for the device.
    std::optional<Dab> dab(const Simulation& simulation, const Parameters& view);

  private:
    // The ground of which terrain, and when.
    struct Ground {
        int terrain_number = 0;
        std::size_t revision = 0;
        Grid grid;
        std::vector<float> heights_m;
        double at(glm::dvec2 place_m) const;
        bool is_of(const Simulation& simulation) const {
            return terrain_number == simulation.terrain_number() &&
                   revision == simulation.journal().revision();
        }
    };

    std::vector<glm::dvec2> points_m_;
    std::optional<std::size_t> built_revision_;  // of the journal; none: these points were not built
    std::size_t operations_when_built_ = 0;      // of the journal, with that act
    std::vector<double> heights_m_;
    std::optional<PathDesign> design_;
    std::vector<glm::dvec2> designed_points_m_;
    PathWishes designed_wishes_;
    std::shared_ptr<const Ground> ground_;           // null: not read yet
    std::shared_ptr<const Ground> designed_ground_;  // that the design goes by
};

/// What the parameters of the section path ask for.
PathWishes path_wishes(const Parameters& view);
/// Those parameters.
std::vector<Parameter> path_parameters();

}  // namespace talus::app
