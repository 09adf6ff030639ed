// What is asked for while a tick goes on that takes for ever: it waits, and undo takes it back, the newest
// first.
#include "app/window/tick_wait.h"

#include <gtest/gtest.h>

#include "app/core/wall_clock.h"
#include "sim/gpu/context.h"
#include "sim/terrain/state_hash.h"

namespace talus::tick_wait_test {
namespace {

class TickWaits : public testing::Test {
  protected:
    TickWaits() {
        app::SceneRequest request;
        request.preset = "blank";
        request.size = glm::ivec2(33, 33);
        session_.emplace(request, context_.device());
        session_->set("water.rain_mm_per_h", 500.0);
        // Over dry ground one sub-step would do.
        session_->set("time.tick_s", 1.0);
        session_->step();
        session_->set("time.tick_s", 1e7);
        before_ = state_hash(session_->simulation().read());
        session_->begin_step();
    }
    // A frame after another, until something is told or the wait is over.
    bool wait() {
        const std::size_t told = told_.size();
        const double begin_s = app::wall_clock_s();
        while (app::wall_clock_s() - begin_s < 20) {
            if (wait_.is_over(*session_, asked_)) return true;
            if (told_.size() > told) return false;
        }
        ADD_FAILURE() << "nothing was told for 20 s";
        return false;
    }
    bool undo() {
        asked_.undo = true;
        return wait();
    }

    const gpu::Context context_;
    std::optional<app::Session> session_;
    std::vector<std::string> told_;
    app::TickWait wait_{[this](const std::string& message) { told_.push_back(message); }};
    app::PanelRequests asked_;
    std::uint64_t before_ = 0;
};

TEST_F(TickWaits, KeepWhatIsAskedForUntilUndoTakesItBack) {
    int done = 0;
    asked_.acts.emplace_back([&](app::Session&) { ++done; });
    asked_.acts.emplace_back([&](app::Session&) { ++done; });
    asked_.save = "a.exr";
    asked_.quit = true;
    EXPECT_FALSE(wait());
    EXPECT_NE(told_.back().find("waits for its end"), std::string::npos);
    EXPECT_EQ(asked_.acts.size(), 2U);
    EXPECT_FALSE(undo());
    EXPECT_EQ(asked_.acts.size(), 1U);
    EXPECT_FALSE(undo());
    EXPECT_TRUE(asked_.acts.empty());
    EXPECT_TRUE(asked_.save);
    EXPECT_FALSE(undo());
    EXPECT_FALSE(asked_.save);
    EXPECT_TRUE(asked_.quit) << "who leaves, leaves";
    EXPECT_EQ(done, 0);
    EXPECT_TRUE(session_->mid_tick()) << "the run is still there";
}

TEST_F(TickWaits, TheSecondUndoTakesTheRunBack) {
    EXPECT_FALSE(undo());
    EXPECT_NE(told_.back().find("once more"), std::string::npos);
    EXPECT_TRUE(wait_.holds_undo());
    EXPECT_TRUE(undo());
    EXPECT_FALSE(session_->mid_tick());
    EXPECT_FALSE(asked_.undo) << "nothing older is undone";
    EXPECT_EQ(state_hash(session_->simulation().read()), before_);
    EXPECT_EQ(session_->simulation().undo_history().undo_name(), "Tick: 10000000 s");
}

// An undo that waits for a tick that ends undoes its run, and what was asked for behind it is done.
TEST_F(TickWaits, OneUndoWaitsForATickThatEnds) {
    session_->give_up_run();
    session_->set("time.tick_s", 0.5);
    session_->begin_step();
    asked_.undo = true;
    while (!wait_.is_over(*session_, asked_)) {
    }
    // On a loaded machine it may have waited so long that it was undone with the wait.
    EXPECT_TRUE(asked_.undo || session_->simulation().can_redo());
    EXPECT_FALSE(wait_.waits());
    if (asked_.undo) session_->undo();
    EXPECT_EQ(state_hash(session_->simulation().read()), before_);
}

}  // namespace
}  // namespace talus::tick_wait_test
