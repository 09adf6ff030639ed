// Tiles that are made ready while somebody looks at a sketch of them.
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <thread>

#include "app/core/opening.h"
#include "app/core/part.h"
#include "app/core/preparation.h"
#include "app/core/tile_sketch.h"
#include "sim/error.h"
#include "sim/gpu/context.h"
#include "sim/io/tile_sidecar.h"
#include "sim/io/tile_writer.h"
#include "tests/scenes/file_size_limit.h"

namespace talus::preparation_test {
namespace {

namespace fs = std::filesystem;

constexpr glm::ivec2 size(2700, 2400);  // in 11 x 10 tiles: too many to be held without overviews

float height_at(int x, int y) {
    return static_cast<float>(700 + 400 * std::sin(0.002 * x) * std::cos(0.003 * y) +
                              20 * std::sin(0.11 * x) + 3 * ((x * 7 + y * 13) % 5));
}

class Preparations : public testing::Test {
  protected:
    Preparations() {
        fs::remove_all(folder_);
        fs::create_directories(folder_);
        setenv("XDG_STATE_HOME", (folder_ / "state").c_str(), 1);
        setenv("XDG_CACHE_HOME", (folder_ / "cache").c_str(), 1);
        io::Heightmap heightmap;
        heightmap.grid = {size.x, size.y, 10, 10};
        heightmap.heights.reserve(heightmap.grid.count());
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x) heightmap.heights.push_back(height_at(x, y));
        io::write_heightmap(path(), heightmap, std::nullopt);
        request_.input = path();
        request_.tiled = true;
    }
    ~Preparations() override { fs::remove_all(folder_); }

    std::string path() const { return folder_ / "plain.tif"; }
    bool is_there(const std::string& ending) const { return fs::exists(path() + ending); }
    void finish(app::Preparation& preparation) const {
        do {
            preparation.poll();
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        } while (preparation.work().busy());
    }
    static void draw(app::Session& session) {
        session.draw(render::view_settings(session.view(), session.simulation().parameters()), {64, 36}, {});
    }

    fs::path folder_ = fs::temp_directory_path() / ("talus_preparation_" + std::to_string(::getpid()));
    app::SceneRequest request_;
    gpu::Context context_;
};

// Over the same grid, by heights that the terrain has; all levels are told from the few samples.
TEST_F(Preparations, BeginWithASketchOfSamples) {
    const app::TiledTerrain sketch = app::sketch_of({path(), {}});
    EXPECT_FALSE(sketch.is_measured);
    EXPECT_EQ(sketch.tree.grid(), (Grid{size.x, size.y, 10, 10}));
    EXPECT_EQ(sketch.tree.coarsest_tiles().size(), 1U);
    EXPECT_GE(sketch.lowest_m, 280);
    EXPECT_LE(sketch.highest_m, 1132);
    const ReadSamples read = sketch.make_reader();
    std::vector<float> heights;
    double off = 0;
    double worst = 0;
    int count = 0;
    for (int level = 0; level <= sketch.tree.top_level(); ++level)
        for (std::size_t i = sketch.tree.first_of(level); i < sketch.tree.first_of(level + 1); ++i) {
            const TileId tile = sketch.tree.tile_at(i);
            const TileSamples samples = sketch.tree.samples_of(tile);
            read(level, samples, heights);
            ASSERT_EQ(heights.size(), static_cast<std::size_t>(samples.count.x) * samples.count.y);
            const glm::ivec2 middle = samples.first + samples.count / 2;
            const glm::dvec2 finest = (glm::dvec2(middle) + 0.5) * sketch.tree.level(level).ratio - 0.5;
            const std::size_t at =
                static_cast<std::size_t>(samples.count.y / 2) * samples.count.x + samples.count.x / 2;
            const double there =
                std::abs(heights[at] - height_at(static_cast<int>(finest.x), static_cast<int>(finest.y)));
            off += there;
            worst = std::max(worst, there);
            ++count;
            ASSERT_GE(heights[at], sketch.bounds[i].lowest_m);
            ASSERT_LE(heights[at], sketch.bounds[i].highest_m);
        }
    // How far off depends on how many samples there was time for.
    std::printf("the sketch is %.1f m off on average, %.1f m at most, of %d tiles\n", off / count, worst,
                count);
    EXPECT_LT(off / count, 60);
    EXPECT_FALSE(is_there(".ovr"));
    EXPECT_FALSE(is_there(".tiles"));
}

// The window has its picture at once; what is made ready takes its place, and the camera stays.
TEST_F(Preparations, EndWithTilesThatAreMeasured) {
    app::Session session(request_, context_.device());
    ASSERT_TRUE(session.overflight());
    ASSERT_TRUE(session.unready());
    EXPECT_NE(session.tiles()->state().find("sketch"), std::string::npos);
    draw(session);
    const Grid grid = session.grid();
    session.camera().eye += glm::dvec3(300, 200, 100);
    const glm::dvec3 eye = session.camera().eye;
    app::set_part(session.view(), {1000, 2000, 3000, 4000});
    std::vector<std::string> notes;
    app::Preparation preparation(session, [&](const std::string& note) { notes.push_back(note); });
    EXPECT_FALSE(preparation.take_progress());
    preparation.poll();
    EXPECT_TRUE(preparation.work().busy());
    EXPECT_TRUE(preparation.take_progress());
    bool has_shown_levels = false;
    while (preparation.work().busy()) {
        preparation.poll();
        draw(session);
        const app::TiledTerrain& shown = session.overflight()->terrain();
        has_shown_levels = has_shown_levels || (!shown.is_measured && shown.file.levels().size() > 1);
    }
    EXPECT_TRUE(has_shown_levels);
    EXPECT_FALSE(session.unready());
    EXPECT_TRUE(session.overflight()->terrain().is_measured);
    EXPECT_NE(session.tiles()->state().find("within"), std::string::npos) << session.tiles()->state();
    EXPECT_EQ(session.grid(), grid);
    EXPECT_EQ(session.camera().eye, eye);
    EXPECT_EQ(app::part_of(session.view()).west_m, 1000);
    EXPECT_EQ(app::part_of(session.view()).north_m, 4000);
    ASSERT_FALSE(notes.empty());
    EXPECT_NE(notes.back().find("is measured"), std::string::npos) << notes.back();
    draw(session);
    // The next one finds all of it.
    const app::TiledTerrain& made = session.overflight()->terrain();
    const auto opened = app::ready_of({path(), {}});
    ASSERT_TRUE(opened);
    EXPECT_EQ(opened->bounds, made.bounds);
    EXPECT_EQ(opened->bounds, measure_tile_bounds(opened->tree, [&] { return opened->file.make_reader(); }));
    const app::Session again(request_, context_.device());
    EXPECT_FALSE(again.unready());
    EXPECT_TRUE(again.overflight()->terrain().is_measured);
    EXPECT_FALSE(made.file.has_changed()) << "the overviews are not another program's doing";
}

// Levels that are there are shown as they are; bounds that terrain mostly keeps stand in for those that are
// not known.
TEST_F(Preparations, SketchLevelsThatAreThere) {
    ASSERT_TRUE(io::write_overviews(io::TiledFile(path(), {}), {}));
    const app::TiledTerrain sketch = app::sketch_of({path(), {}});
    EXPECT_FALSE(sketch.is_measured);
    const auto measured = measure_tile_bounds(sketch.tree, [&] { return sketch.file.make_reader(); });
    for (std::size_t i = 0; i < measured.size(); ++i) {
        EXPECT_LE(sketch.bounds[i].lowest_m, measured[i].lowest_m);
        EXPECT_GE(sketch.bounds[i].highest_m, measured[i].highest_m);
    }
    const TileId top = sketch.tree.coarsest_tiles().front();
    const TileSamples samples = sketch.tree.samples_of(top);
    std::vector<float> shown;
    std::vector<float> read;
    sketch.make_reader()(top.level, samples, shown);
    sketch.file.make_reader()(top.level, samples, read);
    EXPECT_EQ(shown, read);
}

// A part that was cut out has the rest around it when that is ready.
TEST_F(Preparations, BringWhatStandsAround) {
    app::SceneRequest part = request_;
    part.tiled = false;
    part.import.window = io::FileWindow{3000, 3000, 6000, 6000};
    app::Session session(part, context_.device());
    ASSERT_FALSE(session.overflight());
    EXPECT_FALSE(session.surroundings());
    ASSERT_TRUE(session.unready());
    const glm::dvec3 eye = session.camera().eye;
    app::Preparation preparation(session, [](const std::string&) {});
    bool had_a_sketch = false;
    do {
        preparation.poll();
        draw(session);
        had_a_sketch = had_a_sketch ||
                       (session.surroundings() && !session.surroundings()->tiles().terrain().is_measured);
    } while (preparation.work().busy());
    EXPECT_TRUE(had_a_sketch);
    ASSERT_TRUE(session.surroundings());
    EXPECT_TRUE(session.surroundings()->tiles().terrain().is_measured);
    EXPECT_FALSE(session.unready());
    EXPECT_EQ(session.camera().eye, eye);
    // Its whole is the one that it was cut out of, although overviews came since.
    for (const std::string& note : session.scene().document.notes)
        EXPECT_EQ(note.find("was changed"), std::string::npos) << note;
}

// A picture of a part makes no overviews of the whole: a note says what is missing around it.
TEST_F(Preparations, MakeNoOverviewsForAPictureOfAPart) {
    app::SceneRequest part = request_;
    part.tiled = false;
    part.import.window = io::FileWindow{3000, 3000, 6000, 6000};
    const app::Scene scene = app::open_scene(part, app::on_terminal());
    EXPECT_FALSE(scene.whole);
    EXPECT_FALSE(scene.unready);
    ASSERT_FALSE(scene.document.notes.empty());
    EXPECT_NE(scene.document.notes.back().find("has no overviews"), std::string::npos)
        << scene.document.notes.back();
    EXPECT_FALSE(is_there(".ovr"));
    // Where they are there, the whole is measured and shown.
    ASSERT_TRUE(io::write_overviews(io::TiledFile(path(), {}), {}));
    EXPECT_TRUE(app::open_scene(part, app::on_terminal()).whole);
}

// A part can be cut out of a sketch: what is made ready goes on, and stands around the part then.
TEST_F(Preparations, GoOnWhenAPartIsCutOut) {
    app::Session session(request_, context_.device());
    app::Preparation preparation(session, [](const std::string&) {});
    preparation.poll();
    ASSERT_TRUE(preparation.work().busy());
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    const double before_s = preparation.work().seconds();
    app::set_part(session.view(), {3000, 3000, 6000, 6000});
    app::SceneRequest part = app::request_for_part(session);
    // The same file by another name.
    part.input = folder_ / "." / "plain.tif";
    session.open(part, app::open_scene_at_once(part));
    ASSERT_FALSE(session.overflight());
    EXPECT_EQ(session.grid(), (Grid{301, 301, 10, 10}));
    if (preparation.work().busy()) {
        preparation.poll();
        EXPECT_GE(preparation.work().seconds(), before_s) << "it was begun again";
    }
    finish(preparation);
    ASSERT_TRUE(session.surroundings());
    EXPECT_TRUE(session.surroundings()->tiles().terrain().is_measured);
    draw(session);
}

// What the window leaves is not made any further, and no half of it stays.
TEST_F(Preparations, AreGivenUpWithTheScene) {
    {
        app::Session session(request_, context_.device());
        app::Preparation preparation(session, [](const std::string&) {});
        preparation.poll();
        ASSERT_TRUE(preparation.work().busy());
        app::SceneRequest other;
        other.preset = "blank";
        other.size = glm::ivec2(65, 65);
        session.open(other, app::open_scene_at_once(other));
        preparation.poll();
        EXPECT_FALSE(preparation.work().busy());
        EXPECT_FALSE(session.overflight());
    }
    for (const fs::directory_entry& file : fs::directory_iterator(folder_)) {
        const std::string name = file.path().filename();
        EXPECT_TRUE(name == "plain.tif" || name == "plain.tif.ovr" || name == "state" || name == "cache")
            << name;
    }
    if (is_there(".ovr")) {
        EXPECT_GT(io::TiledFile(path(), {}).levels().size(), 1U);
    }
}

// What has ended is not handed to a scene that was opened meanwhile.
TEST_F(Preparations, EndForTheirSceneAlone) {
    app::Session session(request_, context_.device());
    app::Preparation preparation(session, [](const std::string&) {});
    preparation.poll();
    std::this_thread::sleep_for(std::chrono::seconds(3));
    app::SceneRequest other;
    other.preset = "blank";
    other.size = glm::ivec2(65, 65);
    session.open(other, app::open_scene_at_once(other));
    preparation.poll();
    EXPECT_FALSE(session.tiles());
    EXPECT_FALSE(preparation.work().busy());
    // And back: what is there already is not made again.
    session.open(request_, app::open_scene_at_once(request_));
    finish(preparation);
    EXPECT_TRUE(session.tiles()->terrain().is_measured);
}

// Somebody who wants to look and nothing written stops it; the file opened anew is made ready.
TEST_F(Preparations, StopWhenToldTo) {
    app::Session session(request_, context_.device());
    std::vector<std::string> notes;
    app::Preparation preparation(session, [&](const std::string& note) { notes.push_back(note); });
    preparation.poll();
    preparation.give_up();
    for (int i = 0; i < 3; ++i) preparation.poll();
    EXPECT_FALSE(preparation.work().busy());
    ASSERT_EQ(notes.size(), 1U);
    draw(session);
    EXPECT_FALSE(session.tiles()->terrain().is_measured);
    session.reset();
    finish(preparation);
    EXPECT_TRUE(session.tiles()->terrain().is_measured);
}

// Nothing is made for what is not to be seen.
TEST_F(Preparations, WaitForTheBackdropToBeSeen) {
    app::SceneRequest part = request_;
    part.tiled = false;
    part.import.window = io::FileWindow{3000, 3000, 6000, 6000};
    part.assignments = {"tiles.backdrop=false"};
    app::Session session(part, context_.device());
    app::Preparation preparation(session, [](const std::string&) {});
    preparation.poll();
    EXPECT_FALSE(preparation.work().busy());
    EXPECT_FALSE(is_there(".ovr"));
    session.set("tiles.backdrop", true);
    finish(preparation);
    ASSERT_TRUE(session.surroundings());
    EXPECT_TRUE(session.surroundings()->tiles().terrain().is_measured);
}

// Where nothing can be written beside the file, one sentence says so, once, and the sketch stays.
TEST_F(Preparations, SayWhatTheyCannotWrite) {
    app::Session session(request_, context_.device());
    app::Preparation preparation(session, [](const std::string&) {});
    std::string said;
    try {
        const FileSizeLimit limit(30000);
        ASSERT_TRUE(limit.is_set());
        finish(preparation);
    } catch (const Error& error) {
        said = error.what();
    }
    EXPECT_NE(said.find("plain.tif.ovr"), std::string::npos) << said;
    EXPECT_NE(said.find("talus tile"), std::string::npos) << said;
    EXPECT_EQ(said.find('\n'), std::string::npos) << said;
    preparation.poll();
    EXPECT_FALSE(preparation.work().busy());
    EXPECT_TRUE(session.unready());
    draw(session);
    EXPECT_FALSE(is_there(".ovr"));
    // Opened anew, now that it can be written.
    session.open(request_, app::open_scene_at_once(request_));
    finish(preparation);
    EXPECT_TRUE(session.tiles()->terrain().is_measured);
}

// A file that has the overviews' name and is none of Talus's is not replaced.
TEST_F(Preparations, RefuseWhatCannotHaveOverviews) {
    std::ofstream(path() + ".ovr") << "somebody's words";
    using Open = app::TiledTerrain (*)(const app::TiledRequest&);
    for (const Open open :
         {+[](const app::TiledRequest& tiles) {
              return app::sketch_of({tiles.path, tiles.import});
          },
          +[](const app::TiledRequest& tiles) { return app::open_tiled(tiles, app::on_terminal()); }}) {
        try {
            open({path(), {}});
            ADD_FAILURE() << "it was opened";
        } catch (const Error& error) {
            EXPECT_NE(std::string(error.what()).find("plain.tif.ovr' holds no overviews"), std::string::npos)
                << error.what();
        }
    }
    std::ifstream file(path() + ".ovr");
    std::string words;
    std::getline(file, words);
    EXPECT_EQ(words, "somebody's words");
}

}  // namespace
}  // namespace talus::preparation_test
