#pragma once
#include <cstdint>
#include <vector>

#include "sim/simulation.h"

namespace talus::app {

/// A reading of the ledger, and when it was.
struct Balance {
    LedgerReading ledger;
    double simulated_s = 0;
};

/// What the ledger showed over time, for a plot: a few hundred readings, oldest first.
class Balances {
  public:
    const std::vector<Balance>& all() const { return kept_; }
    /// Adds a reading. Drops those of its time or later, which an undo took back, and every other one when
    /// there are too many.
    void keep(const Balance& balance);
    /// Takes what the ledger shows, without waiting, and asks anew about twice a second where something
    /// changed. Once a frame, while somebody looks at it.
    void follow(Simulation& simulation);
    void clear() {
        kept_.clear();
        of_changes_ = 0;
    }

  private:
    std::vector<Balance> kept_;
    double asked_at_s_ = 0;  // of the clock on the wall
    double of_s_ = 0;        // of the simulation, of what was asked for
    std::uint64_t of_changes_ = 0;
};

}  // namespace talus::app
