#pragma once
#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <vector>

#include "sim/gpu/readback.h"
#include "sim/simulation.h"

namespace talus::app {

class Session;

/// A spring of the rate that `spring.rate_m3_per_s` says, as an act; play goes on. Throws talus::Error where
/// the place (m) lies off the map, as all of these do.
void place_spring(Session& session, glm::dvec2 place_m);
/// The same spring elsewhere; at the sample of another one it takes its place. Throws talus::Error too where
/// there is no such spring any more.
void move_spring(Session& session, const Spring& spring, glm::dvec2 place_m);
/// A rate of 0 takes it away. Throws as move_spring().
void set_spring_rate(Session& session, const Spring& spring, double rate_m3_per_s);

/// The ground at each spring, read without waiting, for the signs that stand there.
class SpringHeights {
  public:
    /// Once a frame.
    void follow(const Simulation& simulation);
    /// m, in the order of the springs, a frame or two old; none: not read yet.
    const std::vector<std::optional<double>>& heights_m() const { return heights_m_; }
    /// True while some are on their way.
    bool pending() const;

  private:
    std::vector<Spring> of_;
    std::uint64_t changes_ = 0;  // of the terrain, when they were asked for
    std::vector<std::unique_ptr<gpu::Readback>> readbacks_;
    std::vector<std::optional<double>> heights_m_;
};

}  // namespace talus::app
