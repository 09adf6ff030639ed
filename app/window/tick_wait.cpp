#include "app/window/tick_wait.h"

#include <fmt/format.h>

#include <utility>

#include "app/core/wall_clock.h"
#include "sim/figure.h"

namespace talus::app {

namespace {

// Who leaves, leaves.
void drop_all_but_quit(PanelRequests& asked) {
    const bool quits = asked.quit;
    asked = {};
    asked.quit = quits;
}

}  // namespace

void TickWait::forget() {
    since_s_.reset();
    told_ = false;
    undos_ = 0;
}

bool TickWait::attempt(Session& session, const std::function<void(Session&)>& act) {
    try {
        act(session);
        return true;
    } catch (const std::exception& error) {
        failed_ = true;
        session.playing = false;
        tell_(fmt::format("talus: {}", error.what()));
        return false;
    }
}

void TickWait::go_on(Session& session, double budget_s) {
    // One that failed is not tried again before somebody asks for something.
    if (!failed_) attempt(session, [=](Session& s) { s.end_tick(budget_s); });
}

void TickWait::give_up(Session& session) {
    undos_ = 0;
    if (attempt(session, [](Session& s) { s.give_up_run(); }))
        tell_("the run was taken back; its tick was not waited for");
}

void TickWait::hear_undo(Session& session, PanelRequests& asked) {
    told_ = true;
    if (asked.any()) {
        if (!asked.acts.empty())
            asked.acts.pop_back();
        else if (!asked.parameters.empty())
            asked.parameters.clear();
        else
            drop_all_but_quit(asked);
        return tell_("taken back before it was done");
    }
    ++undos_;
    if (undos_ > 1) return give_up(session);
    tell_("a tick goes on: Undo once more takes the run back with it, and it cannot be redone");
}

bool TickWait::is_over(Session& session, PanelRequests& asked) {
    constexpr double share_s = 0.05;
    constexpr double long_s = 0.5;
    if (session.mid_tick()) {
        const double now_s = wall_clock_s();
        if (!since_s_) since_s_ = now_s;
        // One that ends soon is waited for.
        if (!attempt(session, [=](Session& s) { s.end_tick(share_s); })) {
            if (asked.undo || undos_ > 0) give_up(session);
            drop_all_but_quit(asked);
            undos_ = 0;
        } else if (session.mid_tick() && now_s - *since_s_ >= long_s) {
            if (std::exchange(asked.undo, false)) hear_undo(session, asked);
            if (session.mid_tick() && !std::exchange(told_, true))
                tell_(fmt::format(
                    "a tick of {} s goes on, and what you asked for waits for its end; Undo takes it back",
                    figure(session.simulation().parameters().number("time.tick_s"), 4)));
        }
        if (session.mid_tick()) return false;
    }
    failed_ = false;
    // It was asked for before what waits beside it.
    if (undos_ > 0) attempt(session, [](Session& s) { s.undo(); });
    forget();
    return true;
}

}  // namespace talus::app
