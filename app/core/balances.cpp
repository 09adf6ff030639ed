#include "app/core/balances.h"

#include "app/core/wall_clock.h"

namespace talus::app {

void Balances::keep(const Balance& balance) {
    while (!kept_.empty() && kept_.back().simulated_s >= balance.simulated_s) kept_.pop_back();
    constexpr std::size_t room = 512;
    if (kept_.size() >= room) {
        for (std::size_t i = 1; 2 * i < kept_.size(); ++i) kept_[i] = kept_[2 * i];
        kept_.resize(kept_.size() / 2);
    }
    kept_.push_back(balance);
}

void Balances::follow(Simulation& simulation) {
    if (const auto ledger = simulation.poll_ledger()) keep({*ledger, of_s_});
    if (simulation.awaits_ledger() || simulation.mid_tick()) return;
    const std::uint64_t changes = simulation.terrain().tiles.now();
    if (wall_clock_s() - asked_at_s_ < 0.5 || changes == of_changes_) return;
    asked_at_s_ = wall_clock_s();
    of_s_ = simulation.clock().simulated_s;
    of_changes_ = changes;
    simulation.ask_ledger();
}

}  // namespace talus::app
