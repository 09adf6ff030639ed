// Events that are added, changed and taken away in a window: acts that undo takes back, and that files and
// replay keep.
#include "app/core/scene_events.h"

#include <gtest/gtest.h>

#include "app/core/scene_file.h"
#include "app/core/session.h"
#include "sim/error.h"
#include "sim/gpu/context.h"
#include "sim/journal.h"
#include "sim/preset.h"
#include "sim/terrain/state_hash.h"

namespace talus::scene_events_test {
namespace {

class EventsByHand : public testing::Test {
  protected:
    EventsByHand() { open("dam-break"); }
    void open(const char* preset) {
        request_ = app::SceneRequest();
        request_.preset = preset;
        request_.size = glm::ivec2(65, 65);
        session_.emplace(request_, context_.device());
        begin_ = hash();
    }
    std::uint64_t hash() { return state_hash(session_->simulation().read()); }
    const std::vector<Event>& events() const { return session_->simulation().events(); }
    // From the highest sample to both sides along its row.
    std::pair<glm::dvec3, glm::dvec3> line_over_the_highest() {
        const Grid& grid = session_->grid();
        const std::vector<float> ground = session_->simulation().read().ground();
        const auto highest = std::max_element(ground.begin(), ground.end()) - ground.begin();
        const int row = static_cast<int>(highest / grid.nx);
        const int column = std::clamp(static_cast<int>(highest % grid.nx), 6, grid.nx - 7);
        const auto point = [&](int at) {
            return glm::dvec3(at * grid.dx, (grid.ny - 1 - row) * grid.dy,
                              ground[static_cast<std::size_t>(row) * grid.nx + at]);
        };
        return {point(column - 6), point(column + 6)};
    }

    gpu::Context context_;
    app::SceneRequest request_;
    std::optional<app::Session> session_;
    std::uint64_t begin_ = 0;
};

TEST_F(EventsByHand, AreActsThatUndoAndReplayKnow) {
    app::add_event(*session_, "water.rain");
    ASSERT_EQ(events().size(), 1U);
    EXPECT_EQ(events()[0].at_s, 60);
    EXPECT_EQ(events()[0].assignment, "water.rain_mm_per_h=0");
    Event soon = events()[0];
    soon.at_s = 1;
    soon.assignment = "water.rain_mm_per_h=500";
    app::change_event(*session_, events()[0], soon);
    ASSERT_EQ(events(), std::vector<Event>{soon});
    const double tick_s = session_->simulation().parameters().number("time.tick_s");
    for (double s = 0; s < 3; s += tick_s) session_->step();
    EXPECT_TRUE(events()[0].done);
    EXPECT_EQ(session_->simulation().parameters().number("water.rain_mm_per_h"), 500);
    const std::uint64_t end = hash();
    EXPECT_NE(end, begin_);

    Simulation again(session_->scene().document.state, session_->scene().simulation);
    for (const Operation& one : session_->simulation().journal().operations()) {
        Journal journal;
        journal.record(one);
        const JournalFile read = read_journal(write_journal(session_->scene().start, journal), "a test");
        for (const Operation& told : read.operations) again.apply(told);
    }
    EXPECT_EQ(state_hash(again.read()), end) << "what was recorded leads to the same";

    while (session_->simulation().can_undo()) session_->undo();
    EXPECT_TRUE(events().empty());
    EXPECT_EQ(hash(), begin_);
    while (session_->simulation().can_redo()) session_->redo();
    EXPECT_EQ(hash(), end);
}

TEST_F(EventsByHand, AreChangedByNobodyOnceDone) {
    app::add_event(*session_, "water.boundary.east");
    Event now = events()[0];
    now.at_s = 0;
    app::change_event(*session_, Event(events()[0]), now);
    EXPECT_THROW(app::change_event(*session_, {7, "water.rain=1"}, now), Error) << "there is none";
    session_->step();
    ASSERT_TRUE(events()[0].done);
    Event later = events()[0];
    later.at_s = 99;
    EXPECT_THROW(app::change_event(*session_, Event(events()[0]), later), Error);
    app::remove_event(*session_, now);
    EXPECT_TRUE(events().empty()) << "what is done can be taken off the list, by who saw it before too";
    EXPECT_THROW(app::remove_event(*session_, now), Error);
    EXPECT_THROW(app::add_event(*session_, "time.tick_s"), Error);
    EXPECT_THROW(app::add_event(*session_, "water.sea_level_m"), Error);
    EXPECT_THROW(app::add_event(*session_, "water.nothing"), Error);
    EXPECT_TRUE(events().empty());
}

TEST_F(EventsByHand, AreToldFromOnesLikeThemThatAreDone) {
    app::add_event(*session_, "water.rain");
    Event now = events()[0];
    now.at_s = 0;
    app::change_event(*session_, Event(events()[0]), now);
    session_->step();
    app::add_event(*session_, "water.rain");
    app::change_event(*session_, Event(events()[1]), now);
    ASSERT_EQ(events().size(), 2U);
    ASSERT_TRUE(events()[0].done && !events()[1].done);
    Event later = now;
    later.at_s = 500;
    app::change_event(*session_, Event(events()[1]), later);
    app::change_event(*session_, later, now);
    app::remove_event(*session_, now);
    ASSERT_EQ(events().size(), 1U);
    EXPECT_TRUE(events()[0].done) << "the one that is still to come was taken away";
}

TEST_F(EventsByHand, CutThroughWhatStandsThere) {
    open("alpine");
    const auto [from, to] = line_over_the_highest();
    app::add_breach(*session_, from, to);
    ASSERT_EQ(events().size(), 1U);
    ASSERT_TRUE(events()[0].breach);
    const Breach& breach = *events()[0].breach;
    EXPECT_EQ(breach.bottom_m, std::min(from.z, to.z));
    EXPECT_GT(breach.crest_m, std::max(from.z, to.z));
    EXPECT_GT(breach.over_s, 0);
    Event now = events()[0];
    now.at_s = 0;
    now.breach->over_s = 0;
    app::change_event(*session_, Event(events()[0]), now);
    const float before = session_->bounds().y;
    session_->step();
    const std::vector<float> ground = session_->simulation().read().ground();
    EXPECT_LT(*std::max_element(ground.begin(), ground.end()), before) << "the summit is cut";
    EXPECT_THROW(app::add_breach(*session_, to, to), Error) << "no dam stands on a point";
    EXPECT_THROW(app::add_breach(*session_, from, {1e9, 0, 0}), Error);
    EXPECT_EQ(events().size(), 1U);
}

TEST_F(EventsByHand, AreInTheScene) {
    open("alpine");
    session_->set("water.manning", 0.07);
    app::add_event(*session_, "water.manning");
    app::add_event(*session_, "water.rain");
    Event now = events()[1];
    now.at_s = 0;
    now.assignment = "water.rain_mm_per_h=33";
    app::change_event(*session_, Event(events()[1]), now);
    session_->step();
    const std::string text = app::scene_text("By hand", *session_);
    Preset preset;
    preset.text = text;
    const std::vector<Event> told = events_of(preset);
    ASSERT_EQ(told.size(), 2U);
    EXPECT_EQ(told[0], now) << "it is still to come where the scene begins";
    EXPECT_EQ(told[1].assignment, "water.manning=0.07");
    EXPECT_NE(text.find("manning = 0.07"), std::string::npos) << "what was set before stays: " << text;
    EXPECT_EQ(text.find("rain_mm_per_h = 33"), std::string::npos) << "what the event set is its own";
}

}  // namespace
}  // namespace talus::scene_events_test
