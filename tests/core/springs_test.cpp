// Springs that are placed, moved and taken away in a window: acts that undo takes back; gauges that are
// moved.
#include "app/core/springs.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "app/core/session.h"
#include "sim/error.h"
#include "sim/gpu/context.h"
#include "sim/terrain/state_hash.h"

namespace talus::springs_test {
namespace {

class SpringsByHand : public testing::Test {
  protected:
    SpringsByHand() {
        app::SceneRequest request;
        request.preset = "alpine";
        request.size = glm::ivec2(65, 65);
        session_.emplace(request, context_.device());
        begin_ = hash();
    }
    std::uint64_t hash() { return state_hash(session_->simulation().read()); }
    const std::vector<Spring>& springs() const { return session_->simulation().springs(); }
    std::vector<std::string> done() const { return session_->simulation().undo_history().done(); }

    gpu::Context context_;
    std::optional<app::Session> session_;
    std::uint64_t begin_ = 0;
};

TEST_F(SpringsByHand, AreOneActEach) {
    session_->set("spring.rate_m3_per_s", 25.0);
    app::place_spring(*session_, {500, 1000});
    ASSERT_EQ(springs(), std::vector<Spring>({{500, 1000, 25}}));
    app::move_spring(*session_, springs()[0], {900, 700});
    ASSERT_EQ(springs(), std::vector<Spring>({{900, 700, 25}}));
    app::set_spring_rate(*session_, springs()[0], 7);
    ASSERT_EQ(springs(), std::vector<Spring>({{900, 700, 7}}));
    app::place_spring(*session_, {1200, 1100});
    app::set_spring_rate(*session_, springs()[0], 0);
    ASSERT_EQ(springs(), std::vector<Spring>({{1200, 1100, 25}}));
    EXPECT_EQ(done(), (std::vector<std::string>{"spring", "move a spring", "rate of a spring", "spring",
                                                "remove a spring"}));
    for (int ticks = 0; ticks < 5; ++ticks) session_->step();
    EXPECT_GT(session_->simulation().ledger().water_in, 0) << "it gives water";
    while (session_->simulation().can_undo()) session_->undo();
    EXPECT_TRUE(springs().empty());
    EXPECT_EQ(hash(), begin_);
    while (session_->simulation().can_redo()) session_->redo();
    EXPECT_EQ(springs(), std::vector<Spring>({{1200, 1100, 25}}));
}

TEST_F(SpringsByHand, StayAsTheyWereWhereTheyCannotBe) {
    app::place_spring(*session_, {500, 1000});
    const Spring spring = springs()[0];
    EXPECT_THROW(app::place_spring(*session_, {-1, 1000}), Error);
    EXPECT_THROW(app::move_spring(*session_, spring, {500, 1e9}), Error);
    EXPECT_THROW(app::set_spring_rate(*session_, spring, 1e12), Error);
    EXPECT_EQ(springs(), std::vector<Spring>({spring}));
    EXPECT_EQ(done(), std::vector<std::string>{"spring"});
    // One that is gone is neither moved nor placed again.
    session_->undo();
    EXPECT_THROW(app::move_spring(*session_, spring, {900, 700}), Error);
    EXPECT_THROW(app::set_spring_rate(*session_, spring, 3), Error);
    EXPECT_TRUE(springs().empty());
    EXPECT_TRUE(session_->simulation().can_redo()) << "nothing was done";
}

TEST_F(SpringsByHand, KeepTheirNumbers) {
    const std::vector<Spring> placed = {{500, 1000, 10}, {900, 700, 10}, {300, 300, 10}};
    for (const Spring& one : placed) app::place_spring(*session_, {one.x_m, one.y_m});
    ASSERT_EQ(springs(), placed);
    app::move_spring(*session_, placed[0], {100, 100});
    app::set_spring_rate(*session_, placed[1], 4);
    EXPECT_EQ(springs(), std::vector<Spring>({{100, 100, 10}, {900, 700, 4}, {300, 300, 10}}));
    // At another one's sample it takes its place.
    app::move_spring(*session_, springs()[0], {900, 700});
    EXPECT_EQ(springs(), std::vector<Spring>({{900, 700, 10}, {300, 300, 10}}));
    session_->undo();
    EXPECT_EQ(springs(), std::vector<Spring>({{100, 100, 10}, {900, 700, 4}, {300, 300, 10}}));
}

TEST_F(SpringsByHand, HaveTheGroundThatTheyStandOn) {
    const auto heights = [&] {
        for (int frame = 0; frame < 1000; ++frame) {
            session_->follow_gauges();
            if (!session_->awaits_readbacks()) break;
            std::this_thread::sleep_for(std::chrono::milliseconds(2));
        }
        return session_->spring_heights().heights_m();
    };
    EXPECT_TRUE(heights().empty());
    const Grid grid = session_->grid();
    app::place_spring(*session_, {10 * grid.dx, 20 * grid.dy});
    app::place_spring(*session_, {30 * grid.dx, 40 * grid.dy});
    const auto ground_at = [&](int column, int row) {
        return session_->simulation()
            .read()
            .ground()[static_cast<std::size_t>(grid.ny - 1 - row) * grid.nx + column];
    };
    ASSERT_EQ(heights().size(), 2U);
    EXPECT_EQ(heights()[0], ground_at(10, 20));
    EXPECT_EQ(heights()[1], ground_at(30, 40));
    Dab dab;
    dab.x_m = 10 * grid.dx;
    dab.y_m = 20 * grid.dy;
    dab.radius_m = 3 * grid.dx;
    dab.amount_m = 50;
    session_->apply(dab);
    EXPECT_EQ(heights()[0], ground_at(10, 20)) << "the ground rose under it";
    // Between samples it is the surface's.
    app::move_spring(*session_, springs()[0], {10.25 * grid.dx, 20.5 * grid.dy});
    EXPECT_NEAR(*heights().front(),
                0.5 * (0.75 * ground_at(10, 20) + 0.25 * ground_at(11, 20) + 0.75 * ground_at(10, 21) +
                       0.25 * ground_at(11, 21)),
                1e-3);
    app::set_spring_rate(*session_, springs()[0], 0);
    ASSERT_EQ(heights().size(), 1U);
    EXPECT_EQ(heights()[0], ground_at(30, 40));
}

TEST_F(SpringsByHand, GaugesThatAreMovedBeginAnew) {
    app::Gauges& gauges = session_->gauges();
    const auto record = [&] {
        gauges.record(session_->simulation().terrain(), session_->simulation().clock().simulated_s);
    };
    gauges.place({500, 500});
    gauges.place({1000, 1000});
    record();
    session_->step();
    record();
    ASSERT_EQ(gauges.all()[0].readings.size(), 2U);
    gauges.move(0, {900, 800});
    EXPECT_EQ(gauges.all()[0].place_m, glm::dvec2(900, 800));
    EXPECT_TRUE(gauges.all()[0].readings.empty());
    EXPECT_EQ(gauges.all()[1].readings.size(), 2U) << "the other one goes on";
    session_->step();
    record();
    EXPECT_EQ(gauges.all()[0].readings.size(), 1U);
    EXPECT_EQ(gauges.all()[0].first_row, 2U);
    EXPECT_EQ(gauges.all()[1].readings.size(), 3U);
    EXPECT_THROW(gauges.move(1, {-5, 0}), Error);
    EXPECT_EQ(gauges.all()[1].readings.size(), 3U);
    EXPECT_NO_THROW(gauges.move(7, {1, 1})) << "one that is gone";
    EXPECT_NO_THROW(gauges.remove(7));
    // At the time of the last row it completes that: there is one row for each time.
    gauges.move(0, {100, 100});
    gauges.place({200, 200});
    record();
    EXPECT_EQ(gauges.times_s().size(), 3U);
    for (const app::Gauge& gauge : gauges.all()) EXPECT_EQ(gauge.first_row + gauge.readings.size(), 3U);
    session_->step();
    record();
    EXPECT_EQ(gauges.times_s().size(), 4U);
    for (const app::Gauge& gauge : gauges.all()) EXPECT_EQ(gauge.first_row + gauge.readings.size(), 4U);
}

}  // namespace
}  // namespace talus::springs_test
