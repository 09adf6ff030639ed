#pragma once
#include <functional>
#include <optional>
#include <string>

#include "app/core/dialogs.h"
#include "app/core/session.h"

namespace talus::app {

/// What is asked for needs a whole tick. It waits for the end of one that takes long, and the window does not
/// wait with it.
class TickWait {
  public:
    /// `tell`: says something to the person.
    explicit TickWait(std::function<void(const std::string&)> tell) : tell_(std::move(tell)) {}

    /// Whether what is asked for can be done now; else it stays asked for, and a frame's share of the tick
    /// was done. Undo takes back what waits, the newest first; where nothing does, the second one takes the
    /// run back that the tick is of. Where the tick fails, all that was asked for is dropped.
    bool is_over(Session& session, PanelRequests& asked);
    /// Whether something waits: no other tick begins.
    bool waits() const { return since_s_.has_value(); }
    /// Whether undo waits beside what is asked for.
    bool holds_undo() const { return undos_ > 0; }
    /// Nothing is asked for any more.
    void forget();
    /// A share of a tick that goes on though nobody plays.
    void go_on(Session& session, double budget_s);

  private:
    void hear_undo(Session& session, PanelRequests& asked);
    void give_up(Session& session);
    // False: it failed, which was told.
    bool attempt(Session& session, const std::function<void(Session&)>& act);

    std::function<void(const std::string&)> tell_;
    std::optional<double> since_s_;
    bool told_ = false;
    bool failed_ = false;  // the tick that is half done
    int undos_ = 0;
};

}  // namespace talus::app
