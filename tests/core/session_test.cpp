// A session and its files without a window: what is unsaved, what is asked before something is lost, and what
// the ledger's plot keeps.
#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <thread>

#include "app/core/balances.h"
#include "app/core/project.h"
#include "app/core/wall_clock.h"
#include "sim/error.h"
#include "sim/gpu/context.h"
#include "sim/terrain/state_hash.h"

namespace talus::session_test {
namespace {

namespace fs = std::filesystem;

// A folder of its own, for files and for what sessions keep.
class SessionFiles : public testing::Test {
  protected:
    SessionFiles() : folder_(fs::temp_directory_path() / ("talus_session_" + std::to_string(getpid()))) {
        fs::remove_all(folder_);
        fs::create_directories(folder_);
        setenv("XDG_STATE_HOME", (folder_ / "state").c_str(), 1);
        setenv("XDG_CACHE_HOME", (folder_ / "cache").c_str(), 1);
        context_.emplace();
        app::SceneRequest request;
        request.preset = "blank";
        request.size = glm::ivec2(65, 65);
        session_.emplace(request, context_->device());
        project_.emplace(*session_, state_, "",
                         app::Project::Voice{[this](const std::string& message) { told_.push_back(message); },
                                             [](const std::string&) {}, [] {}, [] {}});
    }
    ~SessionFiles() override {
        project_->end();
        project_.reset();
        session_.reset();
        fs::remove_all(folder_);
    }

    void sculpt() {
        Dab dab;
        dab.x_m = dab.y_m = session_->grid().width_m() / 2;
        dab.radius_m = session_->grid().width_m() / 4;
        dab.amount_m = 5;
        session_->apply(dab);
    }
    void serve(const std::function<void(app::PanelRequests&)>& ask) {
        app::PanelRequests asked;
        ask(asked);
        project_->serve(asked);
        finish();
    }
    void answer(const std::string& words) {
        ASSERT_TRUE(state_.question) << words;
        const app::Question asked = *std::exchange(state_.question, std::nullopt);
        for (const auto& [text, act, at_once] : asked.answers)
            if (text == words) act();
        finish();
    }
    void finish() {
        for (int i = 0; i < 2000 && project_->work().busy(); ++i) {
            project_->poll();
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        }
        ASSERT_FALSE(project_->work().busy());
    }
    std::string file(const std::string& name) const { return (folder_ / name).string(); }

    fs::path folder_;
    std::optional<gpu::Context> context_;
    std::optional<app::Session> session_;
    app::PanelState state_;
    std::optional<app::Project> project_;
    std::vector<std::string> told_;
};

// Until it is there, as the window's frames do.
double scale_end(app::Session& session, const std::string& name) {
    for (int frame = 0; frame < 1000; ++frame) {
        session.follow_scale();
        if (!session.awaits_readbacks()) break;
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    EXPECT_FALSE(session.awaits_readbacks());
    return session.view().number(name);
}

TEST_F(SessionFiles, ScalesOfViewsFollowWhatIsThereAndStayWhileItMoves) {
    app::Session& session = *session_;
    const std::string end = "render.difference_m";
    session.set("render.view", std::string("difference"));
    EXPECT_EQ(scale_end(session, end), 20);  // nothing has changed yet: as it is declared
    sculpt();
    EXPECT_EQ(scale_end(session, end), 5);
    sculpt();
    EXPECT_EQ(scale_end(session, end), 10);
    // What is shown while anything moves keeps its scale, and follows at the end.
    session.playing = true;
    Dab dab;
    dab.x_m = dab.y_m = session.grid().width_m() / 2;
    dab.radius_m = session.grid().width_m() / 4;
    dab.amount_m = 30;
    session.simulation().apply(dab);
    session.simulation().end_entry();
    EXPECT_EQ(scale_end(session, end), 10);
    // Another view gets one at once.
    session.set("render.view", std::string("depth"));
    EXPECT_EQ(scale_end(session, "render.depth_m"), 10) << "as it is declared: there is no water";
    session.set("render.view", std::string("difference"));
    EXPECT_EQ(scale_end(session, end), 40);
    // Another number that is unset moves it as little.
    dab.amount_m = 60;
    session.simulation().apply(dab);
    session.simulation().end_entry();
    session.unset("render.sun_azimuth_deg");
    EXPECT_EQ(scale_end(session, end), 40);
    session.undo();
    session.playing = false;
    session.undo();
    EXPECT_EQ(scale_end(session, end), 10);
    // A number that somebody sets is the scale's end until it is unset.
    session.set(end, 7.0);
    session.undo();
    EXPECT_EQ(scale_end(session, end), 7);
    EXPECT_TRUE(session.is_given(end));
    session.unset(end);
    EXPECT_EQ(scale_end(session, end), 5);
    EXPECT_FALSE(session.is_given(end));
    // What it found is not saved with the project.
    for (const std::string& kept : session.workspace().parameters)
        EXPECT_FALSE(kept.starts_with(end)) << kept;
    // A picture for a file has the scale of what is there, though no frame was drawn.
    session.undo();
    sculpt();
    sculpt();
    sculpt();
    static_cast<void>(session.still({64, 48}));
    EXPECT_EQ(session.view().number(end), 15);
}

TEST_F(SessionFiles, WhatIsDoneIsUnsavedUntilItIsSavedOrTakenBack) {
    EXPECT_FALSE(session_->unsaved());
    sculpt();
    EXPECT_TRUE(session_->unsaved());
    session_->undo();
    EXPECT_FALSE(session_->unsaved());
    session_->redo();
    serve([&](app::PanelRequests& asked) { asked.save = file("a.exr"); });
    EXPECT_FALSE(session_->unsaved());
    EXPECT_EQ(session_->path(), file("a.exr"));
    session_->undo();
    EXPECT_TRUE(session_->unsaved()) << "the file has the dab";
}

TEST_F(SessionFiles, ASavedSessionComesBackToTheBit) {
    sculpt();
    const std::vector<float> ground = session_->simulation().read().ground();
    serve([&](app::PanelRequests& asked) { asked.save = file("a.exr"); });
    sculpt();
    serve([&](app::PanelRequests& asked) {
        app::SceneRequest wish;
        wish.input = file("a.exr");
        asked.open = wish;
    });
    answer("Drop the changes");
    EXPECT_EQ(session_->simulation().read().ground(), ground);
    EXPECT_FALSE(session_->unsaved());
}

TEST_F(SessionFiles, NothingIsLostWithoutAQuestion) {
    sculpt();
    const std::size_t revision = session_->revision();
    bool done = false;
    project_->when_saved([&] { done = true; });
    EXPECT_FALSE(done);
    answer("Cancel");
    EXPECT_FALSE(done);
    EXPECT_EQ(session_->revision(), revision);
    project_->when_saved([&] { done = true; });
    answer("Drop the changes");
    EXPECT_TRUE(done);
}

TEST_F(SessionFiles, AFileIsReplacedOnlyWhenThatWasSaid) {
    std::ofstream(file("b.exr")) << "somebody's";
    sculpt();
    serve([&](app::PanelRequests& asked) { asked.save = file("b.exr"); });
    answer("Cancel");
    EXPECT_EQ(fs::file_size(file("b.exr")), 10U);
    EXPECT_TRUE(session_->unsaved());
    serve([&](app::PanelRequests& asked) { asked.save = file("b.exr"); });
    answer("Replace it");
    EXPECT_GT(fs::file_size(file("b.exr")), 1000U);
    EXPECT_FALSE(session_->unsaved());
}

TEST_F(SessionFiles, AFileThatCannotBeOpenedLeavesEverythingAsItWas) {
    std::ofstream(file("c.tif")) << "no heightmap";
    sculpt();
    session_->saved(file("a.exr"), session_->revision());
    const std::vector<float> ground = session_->simulation().read().ground();
    EXPECT_THROW(serve([&](app::PanelRequests& asked) {
                     app::SceneRequest wish;
                     wish.input = file("c.tif");
                     asked.open = wish;
                 }),
                 Error);
    EXPECT_EQ(session_->simulation().read().ground(), ground);
    EXPECT_EQ(session_->path(), file("a.exr"));
}

TEST_F(SessionFiles, AStrokeIsOneEntryAndPlayingGoesOn) {
    const std::size_t before = session_->simulation().undo_history().done().size();
    const double middle = session_->grid().width_m() / 2;
    session_->begin_stroke({middle, middle, 0});
    for (int i = 0; i < 10; ++i) session_->stroke({middle + i, middle, 0}, 0.02);
    session_->let_go_of_stroke();
    EXPECT_FALSE(session_->stroking());
    EXPECT_GT(session_->sculpting().dabs(), 5);
    EXPECT_EQ(session_->simulation().undo_history().done().size(), before + 1);
    session_->playing = true;
    session_->play(10, 1);
    EXPECT_GT(session_->simulation().clock().simulated_s, 0);
}

TEST(Balances, KeepsAFewHundredOverAnyTimeAndForgetsWhatUndoTookBack) {
    app::Balances balances;
    for (int i = 0; i < 10000; ++i) balances.keep({{}, static_cast<double>(i)});
    const std::vector<app::Balance>& all = balances.all();
    EXPECT_LE(all.size(), 512U);
    EXPECT_GE(all.size(), 256U);
    EXPECT_EQ(all.front().simulated_s, 0);
    EXPECT_EQ(all.back().simulated_s, 9999);
    for (std::size_t i = 1; i < all.size(); ++i) EXPECT_LT(all[i - 1].simulated_s, all[i].simulated_s);
    balances.keep({{}, 5000});
    EXPECT_EQ(balances.all().back().simulated_s, 5000);
    EXPECT_LT(balances.all()[balances.all().size() - 2].simulated_s, 5000);
}

// A tick that takes for ever: the window goes on beside it, and undo takes it back as if it had never begun.
TEST_F(SessionFiles, ATickThatTakesForEverIsGivenUp) {
    sculpt();
    session_->set("water.rain_mm_per_h", 500.0);
    session_->set("time.tick_s", 0.5);
    session_->step();
    const std::uint64_t before = state_hash(session_->simulation().read());
    const std::size_t done = session_->simulation().undo_history().done().size();
    // What two ticks more would be.
    session_->step();
    session_->step();
    const std::uint64_t without = state_hash(session_->simulation().read());
    session_->undo();
    session_->undo();

    session_->set("time.tick_s", 1e7);
    session_->begin_step();
    for (int frame = 0; frame < 5; ++frame) {
        const double begin_s = app::wall_clock_s();
        EXPECT_FALSE(session_->end_tick(0.02));
        EXPECT_LT(app::wall_clock_s() - begin_s, 2);
    }
    session_->give_up_run();
    EXPECT_FALSE(session_->mid_tick());
    EXPECT_FALSE(session_->simulation().can_redo());
    EXPECT_EQ(session_->simulation().undo_history().done().size(), done + 1) << "the tick's length was set";
    session_->undo();
    EXPECT_EQ(state_hash(session_->simulation().read()), before);

    // Ticks after it are those of a session that never began one.
    session_->step();
    session_->step();
    EXPECT_EQ(state_hash(session_->simulation().read()), without);
}

// While a stroke and a run go on in one entry, both are taken back.
TEST_F(SessionFiles, AStrokeOverATickThatTakesForEverIsGivenUpWithIt) {
    session_->set("water.rain_mm_per_h", 500.0);
    // Over dry ground one sub-step would do.
    session_->set("time.tick_s", 1.0);
    session_->step();
    session_->set("time.tick_s", 1e7);
    session_->set("time.speed", 1e6);
    const std::uint64_t before = state_hash(session_->simulation().read());
    const glm::dvec3 middle(session_->grid().width_m() / 2, session_->grid().height_m() / 2, 0);
    session_->begin_stroke(middle);
    session_->stroke(middle, 0.1);
    session_->playing = true;
    for (int frame = 0; frame < 4; ++frame) session_->play(10, 0.02);
    ASSERT_TRUE(session_->mid_tick());
    session_->stroke(middle, 0.1);
    session_->give_up_run();
    EXPECT_FALSE(session_->stroking());
    EXPECT_FALSE(session_->playing);
    EXPECT_EQ(state_hash(session_->simulation().read()), before);
}

}  // namespace
}  // namespace talus::session_test
