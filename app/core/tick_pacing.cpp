#include "app/core/tick_pacing.h"

#include <algorithm>
#include <cmath>

namespace talus::app {

void TickPacing::took(double ms, const Ran& ran) {
    if (ran.ticks > 0) tick_ms_ = ms / ran.ticks;
    if (ran.substeps > 0) substep_ms_ = ms / static_cast<double>(ran.substeps);
}

void TickPacing::stop() {
    owed_s_ = 0;
}

TickPacing::Ran TickPacing::play(const PacedTicks& ticks, const Frame& frame) {
    owed_s_ = std::min(owed_s_ + frame.wall_s * frame.speed, std::max(frame.tick_s, 0.25 * frame.speed));
    const double substep_s = substep_ms_ / 1000;
    const double needed_s = frame.stroking && !ticks.is_mid_tick() ? tick_ms_ / 1000 : substep_s;
    credit_s_ = std::min(credit_s_ + frame.budget_s, std::max(frame.budget_s, 1.2 * needed_s));
    if (needed_s > credit_s_) return {.saved = true};
    const double allowed_s = credit_s_;
    const double fitting = tick_ms_ > 0 ? std::floor(allowed_s * 1000 / tick_ms_) : 1;
    const double begin_s = ticks.now_s();
    const std::uint64_t sent_before = ticks.substeps_sent();
    // Sub-steps go out in batches that fit the budget: each question for what is left costs a device that is
    // not this process more than a sub-step.
    const int batch =
        substep_ms_ > 0 ? static_cast<int>(std::clamp(allowed_s * 1000 / substep_ms_, 1.0, 64.0)) : 1;
    Ran ran;
    // Dabs wait for the end of a tick, so a stroke's frame goes on with it; but not for ever.
    constexpr double longest_s = 0.25;
    const auto fits = [&] {
        const double spent_s = ticks.now_s() - begin_s;
        if (frame.stroking && ticks.is_mid_tick()) return spent_s <= std::max(longest_s, allowed_s);
        return spent_s + substep_s <= allowed_s;
    };
    const auto is_due = [&] {
        if (frame.ends) return ticks.is_mid_tick();
        return owed_s_ >= frame.tick_s * 0.999 && ran.ticks < std::max(1.0, fitting);
    };
    while (is_due() && fits()) {
        if (!ticks.advance(batch)) continue;
        owed_s_ = std::max(owed_s_ - frame.tick_s, 0.0);
        ++ran.ticks;
        if (frame.stroking) break;
    }
    credit_s_ -= ticks.now_s() - begin_s;
    ran.substeps = ticks.substeps_sent() - sent_before;
    return ran;
}

}  // namespace talus::app
