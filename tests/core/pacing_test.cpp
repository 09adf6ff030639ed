// What a frame gives to ticks and to the picture.
#include <gtest/gtest.h>

#include "app/core/frame_pacing.h"
#include "app/core/tick_pacing.h"

namespace talus::pacing_test {
namespace {

// A simulation whose sub-steps take this long on a device that is this process.
struct Fake {
    double substep_s = 0.001;
    int substeps_a_tick = 4;
    double now_s = 0;
    int left = 0;  // of the tick that goes on
    int ticks = 0;
    std::uint64_t sent = 0;

    app::PacedTicks paced() {
        return {[this](int most) {
                    if (left == 0) left = substeps_a_tick;
                    const int run = std::min(most, left);
                    left -= run;
                    sent += static_cast<std::uint64_t>(run);
                    now_s += run * substep_s;
                    ticks += left == 0 ? 1 : 0;
                    return left == 0;
                },
                [this] { return left > 0; }, [this] { return sent; }, [this] { return now_s; }};
    }

    // So many frames of a 60th of a second; returns the longest that ticks took of one, s.
    double play(app::TickPacing& pacing, int frames, app::TickPacing::Frame frame) {
        frame.wall_s = 1.0 / 60;
        double longest_s = 0;
        for (int i = 0; i < frames; ++i) {
            const double begin_s = now_s;
            const app::TickPacing::Ran ran = pacing.play(paced(), frame);
            if (ran.substeps > 0) pacing.took(1000 * (now_s - begin_s), ran);
            longest_s = std::max(longest_s, now_s - begin_s);
        }
        return longest_s;
    }
};

TEST(TickPacing, KeepsToTheSpeedThatIsAskedFor) {
    Fake fake;
    app::TickPacing pacing;
    // Ticks of 4 ms, one in 0.1 s: cheap.
    fake.play(pacing, 600, {.budget_s = 0.01, .tick_s = 0.1, .speed = 1});
    EXPECT_NEAR(fake.ticks, 100, 1);
}

TEST(TickPacing, SpendsNoMoreThanItsBudgetOnAverage) {
    Fake fake;
    app::TickPacing pacing;
    // Wants 600 ticks a second, 2.4 s of work: gets what 5 ms a frame hold.
    const double longest_s = fake.play(pacing, 600, {.budget_s = 0.005, .tick_s = 0.1, .speed = 60});
    EXPECT_LE(fake.now_s, 600 * 0.005 * 1.05);
    EXPECT_GE(fake.now_s, 600 * 0.005 * 0.7);
    EXPECT_LE(longest_s, 0.008);
}

TEST(TickPacing, SavesForASubStepThatIsLongerThanAFrameMaySpend) {
    Fake fake;
    fake.substep_s = 0.05;
    app::TickPacing pacing;
    fake.play(pacing, 600, {.budget_s = 0.005, .tick_s = 0.1, .speed = 60});
    EXPECT_GT(fake.ticks, 5) << "it goes on";
    EXPECT_LE(fake.now_s, 600 * 0.005 + 0.1) << "but not for more than its budget";
}

TEST(TickPacing, DropsWhatCouldNotBeSimulatedInTime) {
    Fake fake;
    app::TickPacing pacing;
    fake.play(pacing, 60, {.budget_s = 0.005, .tick_s = 0.1, .speed = 600});
    fake.substep_s = 1e-6;
    const int before = fake.ticks;
    fake.play(pacing, 1, {.budget_s = 0.005, .tick_s = 0.1, .speed = 0});
    EXPECT_LE(fake.ticks - before, 0.25 * 600 / 0.1 + 1) << "a quarter of a second is caught up at most";
}

TEST(TickPacing, UnderAStrokeEndsTheTickAndBeginsNoOther) {
    Fake fake;
    app::TickPacing pacing;
    for (int frame = 0; frame < 50; ++frame) {
        const int before = fake.ticks;
        fake.play(pacing, 1, {.budget_s = 0.03, .tick_s = 0.001, .speed = 1, .stroking = true});
        EXPECT_LE(fake.ticks - before, 1);
        EXPECT_EQ(fake.left, 0) << "no dab waits for a tick";
    }
    EXPECT_GT(fake.ticks, 20);
}

TEST(TickPacing, NoStrokeWaitsForATickThatTakesForEver) {
    Fake fake;
    fake.substeps_a_tick = 1000000;
    app::TickPacing pacing;
    const double longest_s =
        fake.play(pacing, 200, {.budget_s = 0.01, .tick_s = 1, .speed = 100, .stroking = true});
    EXPECT_LE(longest_s, 0.35);
    EXPECT_GT(fake.now_s, 1) << "it goes on";
}

TEST(TickPacing, EndsATickAndBeginsNoOther) {
    Fake fake;
    fake.substeps_a_tick = 100;
    app::TickPacing pacing;
    fake.left = 90;
    for (int frame = 0; frame < 200 && fake.left > 0; ++frame) {
        const double begin_s = fake.now_s;
        pacing.play(fake.paced(), {.wall_s = 0, .budget_s = 0.005, .tick_s = 1, .speed = 100, .ends = true});
        EXPECT_LE(fake.now_s - begin_s, 0.02);
    }
    EXPECT_EQ(fake.ticks, 1);
    pacing.play(fake.paced(), {.wall_s = 1, .budget_s = 1, .tick_s = 1, .speed = 100, .ends = true});
    EXPECT_EQ(fake.ticks, 1) << "none is half done";
}

TEST(TickPacing, StoppedItOwesNothing) {
    Fake fake;
    app::TickPacing pacing;
    pacing.play(fake.paced(), {.wall_s = 1, .budget_s = 0, .tick_s = 10, .speed = 9.9});
    pacing.stop();
    pacing.play(fake.paced(), {.wall_s = 0.1, .budget_s = 1, .tick_s = 10, .speed = 9.9});
    EXPECT_EQ(fake.ticks, 0);
}

TEST(FramePacing, DrawsAFewFramesAndRests) {
    app::FramePacing pacing;
    for (int i = 0; i < 10; ++i) pacing.begin(false);
    EXPECT_FALSE(pacing.is_awake());
    pacing.wake();
    int frames = 0;
    for (; pacing.is_awake(); ++frames) pacing.begin(false);
    EXPECT_EQ(frames, 3);
    pacing.begin(true);
    EXPECT_TRUE(pacing.is_awake());
}

TEST(FramePacing, LateFramesGetASmallerPictureAndSoonAFullOneAtRest) {
    app::FramePacing pacing;
    for (int i = 0; i < 100; ++i) {
        pacing.took(0.2);
        pacing.picture_scale(true, true);
    }
    EXPECT_EQ(pacing.picture_scale(true, true), 0.3);
    EXPECT_TRUE(pacing.is_late());
    EXPECT_EQ(pacing.picture_scale(false, false), 1);
    for (int i = 0; i < 100; ++i) {
        pacing.took(0.002);
        pacing.picture_scale(true, true);
    }
    EXPECT_EQ(pacing.picture_scale(true, true), 1);
    EXPECT_FALSE(pacing.is_late());
}

TEST(FramePacing, TicksGetWhatAFrameLeavesButNeverNothing) {
    app::FramePacing pacing;
    for (int i = 0; i < 100; ++i) pacing.took(0.001);
    EXPECT_NEAR(pacing.ticks_budget_s(), 1.0 / 60, 1e-9);
    for (int i = 0; i < 100; ++i) pacing.took(1);
    EXPECT_NEAR(pacing.ticks_budget_s(), 1.0 / 240, 1e-9);
}

}  // namespace
}  // namespace talus::pacing_test
