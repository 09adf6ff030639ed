// What a project keeps besides its terrain comes back with it; scenes say again what they were saved from.
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <thread>

#include "app/core/folder_listing.h"
#include "app/core/new_terrain.h"
#include "app/core/outputs.h"
#include "app/core/scene_file.h"
#include "app/core/session.h"
#include "app/core/workspace.h"
#include "sim/error.h"
#include "sim/gpu/context.h"
#include "sim/io/atomic_file.h"
#include "sim/preset.h"
#include "sim/terrain/layers.h"
#include "sim/terrain/state_hash.h"

namespace talus::workspace_test {
namespace {

namespace fs = std::filesystem;

class Workspaces : public testing::Test {
  protected:
    Workspaces() : folder_(fs::temp_directory_path() / ("talus_workspace_" + std::to_string(getpid()))) {
        fs::remove_all(folder_);
        fs::create_directories(folder_);
        setenv("XDG_CACHE_HOME", (folder_ / "cache").c_str(), 1);
    }
    ~Workspaces() override { fs::remove_all(folder_); }

    static app::SceneRequest rain() {
        app::SceneRequest request;
        request.preset = "blank";
        request.assignments = {"terrain.kind=hills",      "terrain.nx=65",   "terrain.ny=49",
                               "water.rain_mm_per_h=500", "time.tick_s=0.5", "thermal.on=false"};
        return request;
    }
    app::SceneRequest of(const std::string& name) const {
        app::SceneRequest request;
        request.input = file(name);
        return request;
    }
    void save(app::Session& session, const std::string& name) const {
        io::Document document = session.document();
        document.workspace = workspace_text(session.workspace());
        io::save_document(file(name), document);
    }
    static void run(app::Session& session, int ticks) {
        for (int i = 0; i < ticks; ++i) {
            session.step();
            // Rows come when the device has them.
            const auto rows = session.gauges().times_s().size();
            for (int wait = 0; wait < 400 && session.gauges().times_s().size() == rows; ++wait) {
                session.follow_gauges();
                std::this_thread::sleep_for(std::chrono::milliseconds(1));
            }
        }
        for (int wait = 0; wait < 20; ++wait) session.follow_gauges();
    }
    std::string file(const std::string& name) const { return (folder_ / name).string(); }

    fs::path folder_;
    gpu::Context context_;
};

TEST_F(Workspaces, AProjectComesBackWithAllThatWasPlacedInIt) {
    app::Session before(rain(), context_.device());
    before.gauges().place({400, 300});
    before.place_section({100, 200, 5}, {500, 210, 7});
    run(before, 3);
    before.gauges().place({120, 130});
    run(before, 2);
    for (const glm::dvec2 point : {glm::dvec2(50, 50), glm::dvec2(200.125, 1.0 / 3)})
        before.path_draft().add(point);
    before.camera().eye = {100.1, -200.2, 300.3};
    before.set("camera.fov_deg", 35.5);
    before.keep_camera("from the dam");
    before.camera().eye.x = 90.7;
    before.set("render.view", std::string("slope"));
    before.set("brush.radius_m", 12.25);
    before.set("time.speed", 7.0);
    before.set("undo.memory_mib", 77);
    EXPECT_TRUE(before.unsaved());
    save(before, "project.exr");

    app::Session after(of("project.exr"), context_.device());
    EXPECT_FALSE(after.unsaved());
    EXPECT_TRUE(after.keeps_camera());
    EXPECT_EQ(after.camera(), before.camera());
    EXPECT_EQ(after.cameras(), before.cameras());
    EXPECT_EQ(after.path_draft().points_m(), before.path_draft().points_m());
    EXPECT_EQ(after.view().choice("render.view"), "slope");
    EXPECT_EQ(after.view().number("brush.radius_m"), 12.25);
    EXPECT_EQ(after.view().number("time.speed"), 7);
    EXPECT_FALSE(after.is_given("render.samples")) << "what nobody set is not set";
    EXPECT_FALSE(after.is_given("undo.memory_mib")) << "memory is the machine's";
    ASSERT_EQ(after.gauges().all().size(), 2U);
    EXPECT_EQ(before.gauges().times_s().size(), 5U);
    EXPECT_EQ(after.gauges().to_csv(), before.gauges().to_csv());
    ASSERT_EQ(after.sections().all().size(), 1U);
    EXPECT_GT(std::abs(before.sections().all().front().volumes_m3.back()), 0);
    EXPECT_EQ(after.sections().to_csv(), before.sections().to_csv());
    EXPECT_EQ(after.sections().all().front().heights_m, glm::dvec2(5, 7));

    // Both go on alike, and the rows with them.
    run(before, 3);
    run(after, 3);
    EXPECT_EQ(state_hash(after.simulation().read()), state_hash(before.simulation().read()));
    EXPECT_EQ(after.gauges().to_csv(), before.gauges().to_csv());
    const auto& volumes = after.sections().all().front().volumes_m3;
    ASSERT_EQ(volumes.size(), before.sections().all().front().volumes_m3.size());
    for (std::size_t i = 0; i < volumes.size(); ++i)
        EXPECT_NEAR(volumes[i], before.sections().all().front().volumes_m3[i], 1e-9 * std::abs(volumes[i]));
}

TEST_F(Workspaces, RowsThatAreOnTheirWayAreSavedToo) {
    app::Session before(rain(), context_.device());
    before.gauges().place({400, 300});
    before.place_section({100, 200, 5}, {500, 210, 7});
    run(before, 2);
    // The window saves at once: nobody has waited for these ticks' rows.
    before.simulation().apply(Ticks{4});
    save(before, "a.exr");
    app::Session after(of("a.exr"), context_.device());
    EXPECT_EQ(after.gauges().times_s().back(), after.simulation().clock().simulated_s);
    const app::PlacedSection& kept = after.sections().all().front();
    EXPECT_EQ(kept.volumes_m3.back(), before.simulation().section_volumes_m3().front());
    run(before, 1);
    run(after, 1);
    EXPECT_EQ(after.gauges().to_csv(), before.gauges().to_csv());
    EXPECT_NEAR(after.sections().all().front().volumes_m3.back(),
                before.sections().all().front().volumes_m3.back(), 1e-9);
}

TEST_F(Workspaces, RowsOfATimeThatWasGoneBackFromAreNotSaved) {
    app::Session session(rain(), context_.device());
    session.gauges().place({400, 300});
    session.place_section({100, 200, 5}, {500, 210, 7});
    run(session, 4);
    session.undo();
    session.undo();
    // Before a frame has followed.
    const app::Workspace kept = session.workspace();
    const double now_s = session.simulation().clock().simulated_s;
    for (const std::vector<double>& times_s : {kept.gauge_times_s, kept.section_times_s}) {
        ASSERT_FALSE(times_s.empty());
        EXPECT_TRUE(std::is_sorted(times_s.begin(), times_s.end()));
        EXPECT_EQ(times_s.back(), now_s);
        EXPECT_EQ(std::adjacent_find(times_s.begin(), times_s.end()), times_s.end());
    }
    EXPECT_EQ(kept.gauges.front().readings.size(), kept.gauge_times_s.size());
}

TEST_F(Workspaces, ARunWithoutAWindowKeepsPlacesAndNoOldRows) {
    app::Session before(rain(), context_.device());
    before.gauges().place({400, 300});
    before.keep_camera("a");
    before.set("render.view", std::string("slope"));
    run(before, 2);
    save(before, "a.exr");
    app::Scene scene = app::make_scene(of("a.exr"));
    Simulation simulation(scene.document.state, scene.simulation);
    app::bring_up(scene.document, simulation);
    EXPECT_EQ(app::workspace_from(scene.document.workspace).gauge_times_s.size(), 2U) << "nothing has run";
    simulation.apply(Ticks{3});
    app::bring_up(scene.document, simulation);
    app::Workspace kept = app::workspace_from(scene.document.workspace);
    EXPECT_TRUE(kept.gauge_times_s.empty());
    ASSERT_EQ(kept.gauges.size(), 1U);
    EXPECT_EQ(kept.gauges.front().place_m, glm::dvec2(400, 300));
    EXPECT_EQ(kept.cameras.size(), 1U);
    simulation.apply(Turn{1});
    app::bring_up(scene.document, simulation);
    kept = app::workspace_from(scene.document.workspace);
    EXPECT_TRUE(kept.gauges.empty() && kept.cameras.empty()) << "they lie elsewhere now";
    EXPECT_FALSE(kept.parameters.empty());
}

TEST_F(Workspaces, WhatIsPlacedIsUnsavedWork) {
    app::Session session(rain(), context_.device());
    int saves = 0;
    const auto is_unsaved_until_saved = [&](const char* what) {
        EXPECT_TRUE(session.unsaved()) << what;
        const std::string name = std::to_string(saves++) + ".exr";
        save(session, name);
        session.saved(file(name), session.revision());
        EXPECT_FALSE(session.unsaved()) << what;
    };
    EXPECT_FALSE(session.unsaved());
    session.keep_camera("a");
    is_unsaved_until_saved("a camera");
    session.gauges().place({400, 300});
    is_unsaved_until_saved("a gauge");
    session.place_section({100, 200, 5}, {500, 210, 7});
    is_unsaved_until_saved("a section");
    for (const glm::dvec2 point : {glm::dvec2(50, 50), glm::dvec2(200, 100)}) session.path_draft().add(point);
    is_unsaved_until_saved("a path");
    session.build_path();
    is_unsaved_until_saved("a path that is built");
    session.step();
    session.undo();
    EXPECT_FALSE(session.unsaved()) << "it is built and saved";
    const app::Session after(of("4.exr"), context_.device());
    EXPECT_TRUE(after.path_draft().points_m().empty()) << "it is in the ground";
    session.undo();
    EXPECT_EQ(session.placed().path_m.size(), 2U) << "taken back, it is a draft again";
    session.redo();
    session.forget_camera("a");
    EXPECT_TRUE(session.unsaved());
    EXPECT_THROW(session.keep_camera(""), Error);
    EXPECT_THROW(session.go_to_camera("a"), Error);
}

TEST_F(Workspaces, ADifferenceGoesOnCountingFromTheFirstStart) {
    app::Session before(rain(), context_.device());
    Dab dab;
    dab.x_m = dab.y_m = 200;
    dab.radius_m = 100;
    dab.amount_m = 5;
    before.apply(dab);
    save(before, "a.exr");
    app::Session middle(of("a.exr"), context_.device());
    middle.apply(dab);
    save(middle, "b.exr");
    const app::Session after(of("b.exr"), context_.device());
    before.apply(dab);
    const std::vector<float> wanted = output_of(before.simulation().read(), "difference");
    const std::vector<float> found = output_of(after.simulation().read(), "difference");
    EXPECT_NEAR(*std::max_element(wanted.begin(), wanted.end()), 10, 0.5);
    EXPECT_EQ(found, wanted);
    // And it is part of no hash: the same ground is the same terrain.
    EXPECT_EQ(state_hash(after.simulation().read()), state_hash(before.simulation().read()));
}

TEST_F(Workspaces, ADifferenceGoesAlongWithTheMap) {
    app::Session session(rain(), context_.device());
    Dab dab;
    dab.x_m = dab.y_m = 200;
    dab.radius_m = 100;
    dab.amount_m = 5;
    session.apply(dab);
    const auto difference = [](const app::Session& of_session) {
        return output_of(of_session.simulation().read(), "difference");
    };
    const std::vector<float> before = difference(session);
    session.apply(Turn{1});
    std::vector<float> turned(before.size());
    const Grid& grid = session.grid();
    for (int y = 0; y < grid.ny; ++y)
        for (int x = 0; x < grid.nx; ++x)
            turned[static_cast<std::size_t>(y) * grid.nx + x] =
                before[static_cast<std::size_t>(x) * grid.ny + (grid.ny - 1 - y)];
    EXPECT_EQ(difference(session), turned);
    session.undo();
    EXPECT_EQ(difference(session), before);
    session.apply(Crop{{150, 150, 250, 250}});
    const std::vector<float> part = difference(session);
    EXPECT_EQ(*std::max_element(part.begin(), part.end()), *std::max_element(before.begin(), before.end()));
    session.undo();
    session.apply(Resample{129, 97});
    const std::vector<float> finer = difference(session);
    EXPECT_NEAR(*std::max_element(finer.begin(), finer.end()), 5, 0.1);
    // Beside the dab nothing has changed, not by a bit: also where layers are resampled each in its way.
    EXPECT_EQ(finer.back(), 0);
    EXPECT_GT(std::count(finer.begin(), finer.end(), 0.0F), static_cast<std::ptrdiff_t>(finer.size() / 2));
    save(session, "a.exr");
    const app::Session after(of("a.exr"), context_.device());
    EXPECT_EQ(difference(after), finer);
}

TEST_F(Workspaces, OneThatCannotBeReadCostsNotTheTerrain) {
    app::Session before(rain(), context_.device());
    for (const char* broken : {"{", "[]", R"({"gauges":{"times_s":[1],"all":[{"at_m":[1]}]}})",
                               R"({"camera":{"eye":[0,0,0],"target":[0,0,0],"fov_deg":50}})"}) {
        io::Document document = before.document();
        document.workspace = broken;
        io::save_document(file("a.exr"), document);
        const app::Session after(of("a.exr"), context_.device());
        EXPECT_EQ(state_hash(after.simulation().read()), state_hash(before.simulation().read()));
        ASSERT_EQ(after.scene().document.notes.size(), 1U) << broken;
        EXPECT_TRUE(after.scene().document.notes.front().starts_with("view, camera, gauges")) << broken;
    }
    // Of another version: what is known is taken.
    app::Workspace newer;
    newer.parameters = {"render.view=slope", "render.view=none such", "render.no_such=1"};
    newer.cameras = {{"a", {}}};
    io::Document later = before.document();
    later.workspace = workspace_text(newer);
    io::save_document(file("a.exr"), later);
    const app::Session known(of("a.exr"), context_.device());
    EXPECT_EQ(known.view().choice("render.view"), "slope");
    EXPECT_EQ(known.cameras(), newer.cameras);
    EXPECT_EQ(known.scene().document.notes.size(), 2U);
    // Readable, and of another map.
    app::Workspace far;
    far.gauges = {{{1e7, 0}, 0, {}}};
    io::Document document = before.document();
    document.workspace = workspace_text(far);
    io::save_document(file("a.exr"), document);
    app::Session after(of("a.exr"), context_.device());
    EXPECT_TRUE(after.gauges().all().empty());
    EXPECT_TRUE(after.take_message().value_or("").starts_with("gauges are not as they were saved"));
}

TEST_F(Workspaces, ASceneMakesItsTerrainAgain) {
    app::Session before(rain(), context_.device());
    before.set("render.view", std::string("slope"));
    before.set("time.speed", 7.0);
    const std::string text = app::scene_text("A \"scene\" of\\mine", before);
    io::write_atomically(file("scene.toml"), text);
    app::SceneRequest request;
    request.preset = file("scene.toml");
    const app::Session after(request, context_.device());
    EXPECT_EQ(after.scene().title, "A \"scene\" of\\mine");
    EXPECT_EQ(state_hash(after.simulation().read()), state_hash(before.simulation().read()));
    EXPECT_EQ(to_toml(after.simulation().parameters()), to_toml(before.simulation().parameters()));
    EXPECT_EQ(after.view().choice("render.view"), "slope");
    EXPECT_EQ(app::scene_text("A \"scene\" of\\mine", after), text);

    save(before, "a.exr");
    const app::Session opened(of("a.exr"), context_.device());
    EXPECT_FALSE(app::can_be_scene(opened));
    before.apply(Turn{1});
    EXPECT_FALSE(app::can_be_scene(before)) << "its generator knows no turns";
    EXPECT_THROW(app::scene_text("a", opened), Error);
}

TEST_F(Workspaces, ASceneBeginsBeforeItsEvents) {
    io::write_atomically(file("events.toml"),
                         "[terrain]\nkind = \"hills\"\nnx = 33\nny = 33\n[water]\nrain_mm_per_h = 50.0\n"
                         "[time]\ntick_s = 1.0\n[[event]]\nat_s = 2\nset = \"water.rain_mm_per_h=0\"\n");
    app::SceneRequest request;
    request.preset = file("events.toml");
    app::Session session(request, context_.device());
    session.simulation().apply(Ticks{5});
    ASSERT_EQ(session.simulation().parameters().number("water.rain_mm_per_h"), 0);
    io::write_atomically(file("again.toml"), app::scene_text("again", session));
    request.preset = file("again.toml");
    app::Session again(request, context_.device());
    EXPECT_EQ(again.simulation().parameters().number("water.rain_mm_per_h"), 50);
    again.simulation().apply(Ticks{5});
    EXPECT_EQ(state_hash(again.simulation().read()), state_hash(session.simulation().read()));
}

TEST(SceneTexts, EventsComeBackAsTheyWere) {
    Event set;
    set.at_s = 600;
    set.assignment = "water.rain_mm_per_h=12.5";
    Event breach;
    breach.at_s = 0.1;
    breach.breach = Breach{{1, 2.5}, {1.0 / 3, 4}, 10, 100, 80, 1.5, 60};
    Preset preset;
    preset.name = "p";
    preset.text = preset_text("p", "[time]\nspeed = 2.0\n", {set, breach});
    EXPECT_EQ(events_of(preset), (std::vector<Event>{set, breach}));
}

TEST_F(Workspaces, ANewTerrainIsWhatWasWished) {
    app::NewTerrain fresh;
    EXPECT_FALSE(fresh.waits());
    fresh.begin();
    for (int i = 0; i < 2000 && !fresh.follow(); ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    EXPECT_EQ(fresh.picture().width(), 320);
    fresh.set("terrain.kind", std::string("valley"));
    fresh.set("terrain.nx", 97);
    fresh.set("terrain.ny", 33);
    fresh.set("terrain.seed", 9);
    fresh.set("water.sea_level_m", 40.0);
    for (int i = 0; i < 2000 && !fresh.follow(); ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    EXPECT_EQ(glm::ivec2(fresh.picture().width(), fresh.picture().height()), glm::ivec2(320, 106));
    const app::Session session(fresh.request(), context_.device());
    EXPECT_EQ(session.scene().title, "New valley");
    EXPECT_EQ(session.grid().nx, 97);
    EXPECT_EQ(session.simulation().parameters().whole("terrain.seed"), 9);
    EXPECT_FALSE(session.simulation().read().water.empty()) << "the sea fills what lies lower";

    // No sea unless it is wished: water at level 0 beyond the edges is not the same as none.
    app::NewTerrain dry;
    const std::vector<std::string> asked = dry.request().assignments;
    EXPECT_TRUE(std::none_of(asked.begin(), asked.end(),
                             [](const std::string& one) { return one.starts_with("water.sea_level_m"); }));

    // What is made to have a shore has its sea, until somebody gives another level.
    dry.set("terrain.kind", std::string("island"));
    dry.set("terrain.relief_m", 200.0);
    EXPECT_EQ(dry.wishes().number("water.sea_level_m"), 50);
    const std::vector<std::string> island = dry.request().assignments;
    EXPECT_EQ(std::count(island.begin(), island.end(), "water.sea_level_m=50"), 1);
    dry.set("water.sea_level_m", 30.0);
    dry.set("terrain.relief_m", 400.0);
    EXPECT_EQ(dry.wishes().number("water.sea_level_m"), 30);
    dry.unset("water.sea_level_m");
    EXPECT_EQ(dry.wishes().number("water.sea_level_m"), 100);
    dry.set("terrain.kind", std::string("hills"));
    EXPECT_EQ(dry.request().assignments.size(), asked.size()) << "hills have none";

    const auto heeds = [&](const std::string& name) {
        const std::vector<std::string> names = fresh.heeded();
        return std::find(names.begin(), names.end(), name) != names.end();
    };
    EXPECT_TRUE(heeds("terrain.seed") && heeds("terrain.relief_m"));
    fresh.set("terrain.kind", std::string("bowl"));
    EXPECT_TRUE(!heeds("terrain.seed") && heeds("terrain.relief_m"));
    fresh.set("terrain.kind", std::string("flat"));
    EXPECT_TRUE(!heeds("terrain.seed") && !heeds("terrain.relief_m"));
    fresh.set("terrain.water", std::string("dam"));
    EXPECT_TRUE(heeds("terrain.relief_m")) << "the dam is so high";
    EXPECT_THROW(fresh.set("terrain.nx", 1), Error);
    EXPECT_EQ(fresh.refusal(), "");
}

TEST(FolderListings, AreSortedAsPeopleCount) {
    std::vector<app::FolderEntry> entries;
    for (const char* name : {"depth_10.tif", "b", "Depth_9.tif", "depth_09.tif", "a2", "A10"})
        entries.push_back({name, "", false, entries.size(), {}});
    entries.push_back({"z", "", true, 0, {}});
    const auto names = [&] {
        std::string all;
        for (const app::FolderEntry& entry : entries) all += entry.name + " ";
        return all;
    };
    app::sort_entries(entries, app::ListedBy::name, false);
    EXPECT_EQ(names(), "z a2 A10 b Depth_9.tif depth_09.tif depth_10.tif ");
    app::sort_entries(entries, app::ListedBy::size, true);
    EXPECT_EQ(names(), "z A10 a2 depth_09.tif Depth_9.tif b depth_10.tif ");
    EXPECT_EQ(app::size_text(999), "999 B");
    EXPECT_EQ(app::size_text(1500), "1.5 kB");
    EXPECT_EQ(app::size_text(999'900), "1.0 MB");
    EXPECT_EQ(app::size_text(123'400'000'000), "123 GB");
}

}  // namespace
}  // namespace talus::workspace_test
