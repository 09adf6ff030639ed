#pragma once
#include <cstdint>
#include <functional>

namespace talus::app {

/// What is paced: a simulation, and the clock on the wall.
struct PacedTicks {
    std::function<bool(int)> advance;  ///< up to so many sub-steps; says whether a tick was completed
    std::function<bool()> is_mid_tick;
    std::function<std::uint64_t()> substeps_sent;
    std::function<double()> now_s;
};

/// How many ticks a frame gets, so that simulated time follows the time on the wall and frames keep coming.
/// Knows no window: what passed and what a frame may spend is told.
class TickPacing {
  public:
    struct Frame {
        double wall_s = 0;    ///< that passed since the last one
        double budget_s = 0;  ///< for ticks, on average
        double tick_s = 1;    ///< simulated
        double speed = 1;     ///< simulated seconds a second
        bool stroking = false;
        bool ends = false;  ///< the tick that is half done ends, and no other begins
    };
    struct Ran {
        int ticks = 0;
        std::uint64_t substeps = 0;
        bool saved = false;  ///< nothing could run yet: the frame was saved for
    };

    /// Runs the ticks that are due, within the budget. For work longer than a frame the budget is saved up;
    /// time that cannot be simulated fast enough is dropped. During a stroke a frame runs one whole tick at
    /// most, because dabs wait for the tick's end; of a tick of more than a quarter of a second a part.
    Ran play(const PacedTicks& ticks, const Frame& frame);
    /// The device time (ms) of what play() ran. The wall clock does not measure the work of an asynchronous
    /// device.
    void took(double ms, const Ran& ran);
    /// Nothing is owed any more.
    void stop();
    /// Of a tick, lately, ms.
    double tick_ms() const { return tick_ms_; }

  private:
    double owed_s_ = 0;    // simulated
    double credit_s_ = 0;  // work that ticks may do and have not
    double tick_ms_ = 0;
    double substep_ms_ = 0;
};

}  // namespace talus::app
