// A part cut out of a raster, worked on and put back: what was not worked on keeps its bits, on every level.
#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>

#include "sim/error.h"
#include "sim/io/atomic_file.h"
#include "sim/io/put_back.h"
#include "sim/io/tile_writer.h"
#include "sim/terrain/bed_beyond.h"
#include "sim/terrain/reshape.h"
#include "sim/terrain/state_hash.h"
#include "tests/scenes/file_size_limit.h"

namespace talus::cut_out_test {
namespace {

namespace fs = std::filesystem;

// No size is a power of two: levels end in halves of samples.
constexpr glm::ivec2 whole_size(1300, 1111);
constexpr double west = 500000;
constexpr double north = 4100000;

float hilly(int x, int y) {
    return static_cast<float>(800 + 300 * std::sin(0.013 * x) * std::cos(0.021 * y) + 1e-3 * (x % 7));
}

float hilly_with_a_hole(int x, int y) {
    return x > 300 && x < 420 && y > 350 && y < 430 ? std::numeric_limits<float>::quiet_NaN() : hilly(x, y);
}

class CutOuts : public ::testing::Test {
  protected:
    void SetUp() override { fs::create_directories(folder_); }
    void TearDown() override { fs::remove_all(folder_); }
    fs::path path(const std::string& name) const { return folder_ / name; }
    const fs::path& folder() const { return folder_; }

    // A raster with samples 10 m east and 20 m south of each other, the first at (west, north).
    fs::path write_whole(const std::string& name, float (*height)(int, int),
                         std::optional<float> void_value = {}) const {
        io::TiledSource source;
        source.grid = {whole_size.x, whole_size.y, 10, 20};
        source.georeference = Georeference{"", {west - 5, 10, 0, north + 10, 0, -20}};
        source.void_value = void_value;
        source.make_reader = [height]() -> ReadSamples {
            return [height](int, const TileSamples& samples, std::vector<float>& heights) {
                heights.clear();
                for (int y = 0; y < samples.count.y; ++y)
                    for (int x = 0; x < samples.count.x; ++x)
                        heights.push_back(height(samples.first.x + x, samples.first.y + y));
            };
        };
        EXPECT_TRUE(io::write_tiled(path(name), source, {}));
        return path(name);
    }

    // The window of the samples from column and row `first` on.
    static io::ImportSettings window(glm::ivec2 first, glm::ivec2 count) {
        io::ImportSettings settings;
        const glm::ivec2 last = first + count - 1;
        settings.window = io::FileWindow{west + 10.0 * first.x, north - 20.0 * last.y, west + 10.0 * last.x,
                                         north - 20.0 * first.y};
        return settings;
    }

    template <typename Act>
    static std::string refusal(const Act& act) {
        try {
            act();
        } catch (const Error& error) {
            return error.what();
        }
        return "nothing was refused";
    }

  private:
    fs::path folder_ = fs::temp_directory_path() / ("talus_cut_out_" + std::to_string(::getpid()));
};

std::vector<float> level_of(const io::TiledFile& file, int level) {
    std::vector<float> heights;
    file.source().make_reader()(level, {glm::ivec2(0), file.levels()[static_cast<std::size_t>(level)]},
                                heights);
    return heights;
}

// Raises the ground of a rectangle of the terrain's own samples.
void raise(io::Document& document, glm::ivec2 from, glm::ivec2 to, float by_m) {
    for (int y = from.y; y < to.y; ++y)
        for (int x = from.x; x < to.x; ++x)
            document.state.bedrock[static_cast<std::size_t>(y) * document.state.grid.nx + x].x += by_m;
}

std::size_t different(const std::vector<float>& a, const std::vector<float>& b) {
    std::size_t count = a.size() == b.size() ? 0 : std::max(a.size(), b.size());
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
        count += a[i] == b[i] || (std::isnan(a[i]) && std::isnan(b[i])) ? 0 : 1;
    return count;
}

TEST_F(CutOuts, AreTheSamplesOfTheirWindow) {
    const fs::path whole = write_whole("whole.tif", hilly);
    const io::Document document = io::open_document(whole, window({200, 300}, {150, 80}));
    EXPECT_EQ(document.state.grid, (Grid{150, 80, 10, 20}));
    const std::vector<float> ground = document.state.ground();
    for (int y = 0; y < 80; ++y)
        for (int x = 0; x < 150; ++x)
            ASSERT_EQ(ground[static_cast<std::size_t>(y) * 150 + x], hilly(200 + x, 300 + y))
                << x << ", " << y;
    EXPECT_EQ(document.state.georeference->transform,
              (std::array<double, 6>{west + 1995, 10, 0, north - 5990, 0, -20}));

    // A window between samples takes those around it; one beyond the edge ends there.
    io::ImportSettings settings = window({200, 300}, {150, 80});
    settings.window->west -= 1;
    settings.window->south -= 1;
    EXPECT_EQ(io::open_document(whole, settings).state.grid, (Grid{151, 81, 10, 20}));
    settings.window->east = west + 1e6;
    EXPECT_EQ(io::open_document(whole, settings).state.grid, (Grid{whole_size.x - 199, 81, 10, 20}));
    for (const io::FileWindow bad :
         {io::FileWindow{west + 500, north - 500, west + 100, north - 100}, io::FileWindow{0, 0, 10, 10},
          io::FileWindow{west + 13, north - 33, west + 13, north - 33}}) {
        settings.window = bad;
        EXPECT_NE(refusal([&] { io::open_document(whole, settings); }).find("whole.tif"), std::string::npos);
    }
}

TEST_F(CutOuts, KnowTheGroundBeyondTheirEdges) {
    const fs::path whole = write_whole("whole.tif", hilly_with_a_hole, -9999.0F);
    std::vector<float> read;
    const io::TiledFile file(whole, {});
    file.source().make_reader()(0, {glm::ivec2(0), whole_size}, read);
    const auto expect_bed = [&](const io::Document& part, glm::ivec2 first) {
        EXPECT_EQ(part.state.bed_beyond, bed_beyond_of(part.state.grid, [&](glm::ivec2 at) {
                      const glm::ivec2 p = first + at;
                      const bool inside = p.x >= 0 && p.y >= 0 && p.x < whole_size.x && p.y < whole_size.y;
                      const float bed = inside ? read[static_cast<std::size_t>(p.y) * whole_size.x + p.x]
                                               : glsl::unknown_bed;
                      return std::isnan(bed) ? glsl::unknown_bed : bed;
                  }));
    };
    expect_bed(io::open_document(whole, window({500, 300}, {150, 80})), {500, 300});
    // Beside a hole, where nothing is known; in two corners of the whole; and as small as can be.
    expect_bed(io::open_document(whole, window({420, 360}, {70, 60})), {420, 360});
    expect_bed(io::open_document(whole, window({0, 1}, {70, 60})), {0, 1});
    expect_bed(io::open_document(whole, window(whole_size - 60, {60, 60})), whole_size - 60);
    const io::Document smallest = io::open_document(whole, window({500, 300}, {2, 2}));
    expect_bed(smallest, {500, 300});
    io::save_document(path("smallest.exr"), smallest);
    EXPECT_EQ(io::open_document(path("smallest.exr"), {}).state.bed_beyond, smallest.state.bed_beyond);

    // A document keeps it, and refuses what cannot be.
    io::Document document = io::open_document(whole, window({0, 1}, {70, 60}));
    io::save_document(path("work.exr"), document);
    EXPECT_EQ(io::open_document(path("work.exr"), {}).state.bed_beyond, document.state.bed_beyond);
    document.state.bed_beyond.pop_back();
    io::save_document(path("short.exr"), document);
    const std::string too_few = refusal([&] { io::open_document(path("short.exr"), {}); });
    EXPECT_NE(too_few.find("short.exr"), std::string::npos) << too_few;
    EXPECT_NE(too_few.find("519"), std::string::npos) << too_few;
    document.state.bed_beyond.push_back(std::numeric_limits<float>::quiet_NaN());
    io::save_document(path("nan.exr"), document);
    EXPECT_NE(refusal([&] { io::open_document(path("nan.exr"), {}); }).find("finite"), std::string::npos);
}

TEST_F(CutOuts, AreKnownFromDocumentsAndJournals) {
    const fs::path whole = write_whole("whole.tif", hilly);
    const io::ImportSettings settings = window({10, 20}, {64, 70});
    const io::Document document = io::open_document(whole, settings);
    ASSERT_TRUE(document.cut_out);
    EXPECT_EQ(io::import_settings_from(io::to_text(settings)).window, settings.window);
    io::save_document(path("work.exr"), document);
    io::Document again = io::open_document(path("work.exr"), {});
    ASSERT_TRUE(again.cut_out);
    EXPECT_EQ(again.cut_out->path, document.cut_out->path);
    EXPECT_EQ(again.cut_out->fingerprint, document.cut_out->fingerprint);
    EXPECT_FALSE(again.cut_out->import.window);
    EXPECT_EQ(state_hash(again.state), state_hash(document.state));
    const io::TiledFile file(whole, {});
    EXPECT_EQ(io::first_sample_in(file, again.state.grid, again.state.georeference), glm::ivec2(10, 20));
    // Both were moved to another folder.
    fs::create_directory(path("moved"));
    fs::rename(whole, path("moved/whole.tif"));
    fs::rename(path("work.exr"), path("moved/work.exr"));
    again = io::open_document(path("moved/work.exr"), {});
    EXPECT_EQ(again.cut_out->path, path("moved/whole.tif"));
    // A window is of a raster, not of a document.
    EXPECT_NE(refusal([&] { io::open_document(path("moved/work.exr"), settings); }).find("--window"),
              std::string::npos);
}

TEST_F(CutOuts, ArePutBackAndTheRestKeepsItsBits) {
    const fs::path whole = write_whole("whole.tif", hilly);
    const std::string bytes = io::read_text(whole);
    io::Document document = io::open_document(whole, window({200, 300}, {150, 80}));
    raise(document, {30, 20}, {60, 50}, 25);
    const std::optional<io::PutBack> done = io::put_back(document, {path("out.vrt")}, {});
    ASSERT_TRUE(done);
    EXPECT_EQ(done->changed, 30 * 30);
    EXPECT_EQ(done->rectangle.first, glm::ivec2(0));
    EXPECT_EQ(done->rectangle.count, glm::ivec2(512));
    EXPECT_EQ(io::read_text(whole), bytes);

    const io::TiledFile before(whole, {});
    const io::TiledFile after(path("out.vrt"), {});
    EXPECT_EQ(after.grid(), before.grid());
    EXPECT_EQ(after.georeference(), before.georeference());
    EXPECT_EQ(after.level_places(), before.level_places());
    ASSERT_EQ(after.levels(), before.levels());
    std::vector<float> expected = level_of(before, 0);
    for (int y = 320; y < 350; ++y)
        for (int x = 230; x < 260; ++x) expected[static_cast<std::size_t>(y) * whole_size.x + x] += 25;
    EXPECT_EQ(different(level_of(after, 0), expected), 0U);
    // Levels are what `talus tile` would make of the changed whole.
    io::TiledSource changed = before.source();
    changed.make_reader = [&]() -> ReadSamples {
        return [&](int, const TileSamples& samples, std::vector<float>& heights) {
            heights.clear();
            for (int y = 0; y < samples.count.y; ++y)
                for (int x = 0; x < samples.count.x; ++x)
                    heights.push_back(expected[static_cast<std::size_t>(samples.first.y + y) * whole_size.x +
                                               samples.first.x + x]);
        };
    };
    ASSERT_TRUE(io::write_tiled(path("changed.tif"), changed, {}));
    const io::TiledFile made(path("changed.tif"), {});
    for (int level = 1; level < static_cast<int>(before.levels().size()); ++level) {
        EXPECT_EQ(different(level_of(after, level), level_of(made, level)), 0U) << level;
        EXPECT_GT(different(level_of(after, level), level_of(before, level)), 0U) << level;
    }
}

TEST_F(CutOuts, ReachTheWholesFarCorner) {
    const fs::path whole = write_whole("whole.tif", hilly);
    io::Document document = io::open_document(whole, window(whole_size - 90, {90, 90}));
    raise(document, {80, 80}, {90, 90}, 3);
    const std::optional<io::PutBack> done = io::put_back(document, {path("out.vrt"), 200}, {});
    ASSERT_TRUE(done);
    // No feather where the whole itself ends.
    EXPECT_EQ(done->changed, 100);
    EXPECT_EQ(done->rectangle.first + done->rectangle.count, whole_size);
    const io::TiledFile before(whole, {});
    const io::TiledFile after(path("out.vrt"), {});
    for (int level = 0; level < static_cast<int>(before.levels().size()); ++level) {
        const std::vector<float> a = level_of(after, level);
        const std::vector<float> b = level_of(before, level);
        EXPECT_NE(a.back(), b.back()) << level;
        EXPECT_EQ(a.front(), b.front()) << level;
    }
}

TEST_F(CutOuts, FadeIntoTheWholeWithinAFeather) {
    const fs::path whole = write_whole("whole.tif", hilly);
    io::Document document = io::open_document(whole, window({200, 300}, {150, 80}));
    raise(document, {0, 0}, {150, 80}, 10);
    ASSERT_TRUE(io::put_back(document, {path("out.vrt"), 200}, {}));
    const io::TiledFile after(path("out.vrt"), {});
    const std::vector<float> heights = level_of(after, 0);
    const auto raised = [&](int x, int y) {
        return heights[static_cast<std::size_t>(300 + y) * whole_size.x + 200 + x] - hilly(200 + x, 300 + y);
    };
    for (int x = 0; x < 150; ++x) {
        EXPECT_EQ(raised(x, 0), 0) << x;
        EXPECT_EQ(raised(x, 79), 0) << x;
    }
    EXPECT_EQ(raised(0, 40), 0);
    EXPECT_EQ(raised(149, 40), 0);
    EXPECT_NEAR(raised(10, 40), 5, 1e-3);  // in the middle of the feather
    EXPECT_NEAR(raised(20, 40), 10, 1e-3);
    for (int x = 1; x <= 20; ++x) EXPECT_GT(raised(x, 40), raised(x - 1, 40)) << x;
    for (const double bad : {-1.0, std::nan("")})
        EXPECT_NE(refusal([&] {
                      io::put_back(document, {path("out.vrt"), bad}, {});
                  }).find("feather"),
                  std::string::npos);
}

TEST_F(CutOuts, KeepVoidsThatNothingFilled) {
    const fs::path whole = write_whole("whole.tif", hilly_with_a_hole, -32768.0F);
    io::Document document = io::open_document(whole, window({280, 330}, {100, 60}));
    raise(document, {0, 0}, {40, 30}, 4);  // its last columns and rows lie in the hole
    ASSERT_TRUE(io::put_back(document, {path("out.vrt")}, {}));
    const io::TiledFile before(whole, {});
    const io::TiledFile after(path("out.vrt"), {});
    const std::vector<float> old_heights = level_of(before, 0);
    const std::vector<float> heights = level_of(after, 0);
    for (int y = 0; y < whole_size.y; ++y)
        for (int x = 0; x < whole_size.x; ++x) {
            const std::size_t at = static_cast<std::size_t>(y) * whole_size.x + x;
            const bool worked_on = x >= 280 && x < 320 && y >= 330 && y < 360;
            ASSERT_EQ(std::isnan(heights[at]), !worked_on && std::isnan(hilly_with_a_hole(x, y)))
                << x << ", " << y;
            if (!worked_on && !std::isnan(old_heights[at])) {
                ASSERT_EQ(heights[at], old_heights[at]);
            }
        }
}

TEST_F(CutOuts, AreCutOutOfWhatWasPutBack) {
    const fs::path whole = write_whole("whole.tif", hilly);
    io::Document first = io::open_document(whole, window({100, 100}, {50, 50}));
    raise(first, {10, 10}, {20, 20}, 5);
    ASSERT_TRUE(io::put_back(first, {path("a.vrt"), 0}, {}));
    io::Document second = io::open_document(path("a.vrt"), window({115, 100}, {50, 50}));
    raise(second, {0, 0}, {10, 20}, 7);
    ASSERT_TRUE(io::put_back(second, {path("b.vrt"), 0}, {}));
    const std::vector<float> heights = level_of(io::TiledFile(path("b.vrt"), {}), 0);
    const auto raised = [&](int x, int y) {
        return heights[static_cast<std::size_t>(y) * whole_size.x + x] - hilly(x, y);
    };
    EXPECT_NEAR(raised(112, 115), 5, 1e-3);
    EXPECT_NEAR(raised(117, 115), 12, 1e-3);
    EXPECT_NEAR(raised(122, 115), 7, 1e-3);
    EXPECT_EQ(raised(130, 115), 0);
    // What it is made of is not written to, however deep it lies.
    io::Document third = io::open_document(path("b.vrt"), window({115, 100}, {50, 50}));
    raise(third, {0, 0}, {10, 20}, 7);
    for (const char* const name : {"a.vrt", "b.vrt"}) {
        const std::string before = io::read_text(path(name));
        EXPECT_NE(refusal([&] { io::put_back(third, {path(name), 0}, {}); }).find(name), std::string::npos);
        EXPECT_EQ(io::read_text(path(name)), before);
    }
    // Again to the same place: the new patch alone. Its levels are those of the mosaic below, where it is
    // not.
    raise(second, {0, 0}, {10, 20}, 1);
    const std::optional<io::PutBack> again = io::put_back(second, {path("b.vrt"), 0}, {});
    ASSERT_TRUE(again);
    EXPECT_EQ(again->patch, path("b.parts/2/patch.tif"));
    EXPECT_FALSE(fs::exists(path("b.parts/1")));
    {
        const io::TiledFile below(path("a.vrt"), {});
        const io::TiledFile above(path("b.vrt"), {});
        for (int level = 0; level < static_cast<int>(below.levels().size()); ++level) {
            const glm::ivec2 size = below.levels()[static_cast<std::size_t>(level)];
            const std::vector<float> a = level_of(below, level);
            const std::vector<float> b = level_of(above, level);
            const int end = 512 >> level;
            for (int y = 0; y < size.y; ++y)
                for (int x = 0; x < size.x; ++x) {
                    const std::size_t at = static_cast<std::size_t>(y) * size.x + x;
                    if (x >= end || y >= end) {
                        ASSERT_EQ(a[at], b[at]) << level << ": " << x << ", " << y;
                    }
                }
        }
    }
    EXPECT_NEAR(
        level_of(io::TiledFile(path("b.vrt"), {}), 0)[static_cast<std::size_t>(115) * whole_size.x + 122] -
            hilly(122, 115),
        8, 1e-3);
}

// Whatever folders and files are called; both are moved, and the mosaic still knows its parts.
TEST_F(CutOuts, FindTheirPartsFromTheMosaic) {
    fs::create_directories(path("a & <b>/x y"));
    const fs::path whole = write_whole("a & <b>/whole \"1\".tif", hilly);
    io::Document document = io::open_document(whole, window({200, 300}, {80, 80}));
    raise(document, {5, 5}, {9, 9}, 2);
    ASSERT_TRUE(io::put_back(document, {path("a & <b>/x y/ö & ü.vrt"), 0}, {}));
    fs::rename(path("a & <b>"), path("moved"));
    const io::TiledFile mosaic(path("moved/x y/ö & ü.vrt"), {});
    const std::vector<float> heights = level_of(mosaic, 0);
    EXPECT_FLOAT_EQ(heights[static_cast<std::size_t>(306) * whole_size.x + 206], hilly(206, 306) + 2);
    EXPECT_EQ(heights.front(), hilly(0, 0));
    level_of(mosaic, 1);
    // Without a part nothing is made up.
    ASSERT_TRUE(fs::remove(path("moved/x y/ö & ü.parts/1/patch.tif")));
    const std::string said = refusal([&] {
        const io::TiledFile broken(path("moved/x y/ö & ü.vrt"), {});
        level_of(broken, 0);
    });
    EXPECT_NE(said.find("patch.tif"), std::string::npos) << said;
}

// What was there before is there still, and it is said in a sentence.
TEST_F(CutOuts, LoseNothingWhereThereIsNoSpace) {
    const fs::path whole = write_whole("whole.tif", hilly);
    io::Document document = io::open_document(whole, window({200, 300}, {150, 80}));
    raise(document, {30, 20}, {60, 50}, 25);
    const std::optional<io::PutBack> done = io::put_back(document, {path("out.vrt")}, {});
    ASSERT_TRUE(done);
    const std::string mosaic = io::read_text(path("out.vrt"));
    const std::string patch = io::read_text(done->patch);
    const auto files = [&] {
        return std::distance(fs::recursive_directory_iterator(folder()), fs::recursive_directory_iterator());
    };
    const auto files_before = files();
    raise(document, {90, 40}, {120, 70}, 25);
    // For the patch, and for the mosaic's text too.
    for (const rlim_t bytes : {100000U, 300U}) {
        const std::string said = refusal([&] {
            const FileSizeLimit limit(bytes);
            EXPECT_TRUE(limit.is_set());
            io::put_back(document, {path("out.vrt")}, {});
        });
        EXPECT_NE(said.find("cannot write"), std::string::npos) << said;
        EXPECT_EQ(said.find('\n'), std::string::npos) << said;
        EXPECT_EQ(io::read_text(path("out.vrt")), mosaic);
        EXPECT_EQ(io::read_text(done->patch), patch);
        EXPECT_EQ(files(), files_before);
    }
}

// A mosaic of a mosaic of a mosaic opens as fast: each part is looked at once.
TEST_F(CutOuts, MayBePutBackManyTimes) {
    fs::path whole = write_whole("whole.tif", hilly);
    const auto begin = std::chrono::steady_clock::now();
    for (int generation = 1; generation <= 8; ++generation) {
        io::Document document = io::open_document(whole, window({100 + 20 * generation, 100}, {50, 50}));
        raise(document, {10, 10}, {20, 20}, 5);
        whole = path("g" + std::to_string(generation) + ".vrt");
        ASSERT_TRUE(io::put_back(document, {whole, 0}, {})) << generation;
    }
    const io::TiledFile last(whole, {});
    const std::vector<float> heights = level_of(last, 0);
    for (int generation = 1; generation <= 8; ++generation) {
        const int x = 115 + 20 * generation;
        EXPECT_NEAR(heights[static_cast<std::size_t>(115) * whole_size.x + x] - hilly(x, 115), 5, 1e-3)
            << generation;
    }
    EXPECT_TRUE(io::is_made_of(last.path(), path("whole.tif")));
    EXPECT_TRUE(io::is_made_of(last.path(), path("g1.vrt")));
    EXPECT_FALSE(last.has_changed());
    EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(60));
}

// What another program changed in the whole is not taken for work.
// Overviews that Talus made of a mosaic go with it: other programs would believe them of the next one.
TEST_F(CutOuts, TakeOutdatedOverviewsAway) {
    const fs::path whole = write_whole("whole.tif", hilly);
    io::Document document = io::open_document(whole, window({200, 300}, {90, 90}));
    raise(document, {20, 20}, {60, 60}, 3);
    ASSERT_TRUE(io::put_back(document, {path("out.vrt"), 0}, {}));
    // As if the mosaic had no levels of its own.
    std::string text = io::read_text(path("out.vrt"));
    for (std::size_t at = text.find("<Overview>"); at != std::string::npos; at = text.find("<Overview>"))
        text.erase(at, text.find("</Overview>") + 11 - at);
    io::write_atomically(path("out.vrt"), text);
    ASSERT_TRUE(io::write_overviews(io::TiledFile(path("out.vrt"), {}), {}));
    ASSERT_EQ(io::TiledFile(path("out.vrt"), {}).overviews(), io::TiledFile::Overviews::some);
    ASSERT_TRUE(io::put_back(document, {path("out.vrt"), 0}, {}));
    EXPECT_FALSE(fs::exists(path("out.vrt.ovr")));
}

TEST_F(CutOuts, SayWhereTheWholeIsAnotherOne) {
    const fs::path whole = write_whole("whole.tif", hilly);
    io::Document document = io::open_document(whole, window({200, 300}, {80, 80}));
    raise(document, {5, 5}, {9, 9}, 2);
    write_whole("whole.tif",
                [](int x, int y) { return hilly(x, y) + (x == 240 && y == 340 ? 50.0F : 0.0F); });
    fs::last_write_time(whole, fs::last_write_time(whole) + std::chrono::seconds(5));
    const std::string said = refusal([&] { io::put_back(document, {path("out.vrt")}, {}); });
    EXPECT_NE(said.find("was changed since"), std::string::npos) << said;
    EXPECT_FALSE(fs::exists(path("out.vrt")));
    ASSERT_TRUE(io::put_back(document, {path("out.vrt"), 0, true}, {}));
    EXPECT_EQ(
        level_of(io::TiledFile(path("out.vrt"), {}), 0)[static_cast<std::size_t>(340) * whole_size.x + 240],
        hilly(240, 340));
}

// Where the mosaic's name is a link, it stands where that leads, with its levels.
TEST_F(CutOuts, FollowLinks) {
    fs::create_directories(path("there"));
    fs::create_directories(path("data"));
    write_whole("data/real.tif", hilly);
    fs::create_symlink(path("data/real.tif"), path("link.tif"));
    std::ofstream(path("there/out.vrt")) << "before";
    fs::create_symlink(path("there/out.vrt"), path("out.vrt"));
    io::Document document = io::open_document(path("link.tif"), window({200, 300}, {80, 80}));
    raise(document, {5, 5}, {9, 9}, 2);
    ASSERT_TRUE(io::put_back(document, {path("out.vrt")}, {}));
    EXPECT_TRUE(fs::is_symlink(path("out.vrt")));
    for (const char* const name : {"out.vrt", "there/out.vrt"}) {
        const io::TiledFile mosaic(path(name), {});
        EXPECT_EQ(mosaic.levels(), io::TiledFile(path("data/real.tif"), {}).levels()) << name;
        level_of(mosaic, 2);
    }
}

TEST_F(CutOuts, AreRefusedWhereTheyHaveNoPlace) {
    const fs::path whole = write_whole("whole.tif", hilly);
    io::Document document = io::open_document(whole, window({200, 300}, {80, 80}));
    const auto refused = [&](const io::Document& what, const char* name = "out.vrt") {
        return refusal([&] { io::put_back(what, {path(name), 0}, {}); });
    };
    EXPECT_NE(refused(document).find("nothing is to be put back"), std::string::npos);
    raise(document, {5, 5}, {9, 9}, 2);
    EXPECT_NE(refused(document, "out.tif").find(".vrt"), std::string::npos);
    EXPECT_NE(refused(document, "no/such/folder/out.vrt").find("no/such/folder"), std::string::npos);

    io::Document changed = document;
    changed.cut_out.reset();
    EXPECT_NE(refused(changed).find("--window"), std::string::npos);
    changed = document;
    changed.state = turned(document.state, 2);
    EXPECT_NE(refused(changed).find("turned or resampled"), std::string::npos);
    changed.state = resampled(document.state, 40, 40);
    EXPECT_NE(refused(changed).find("turned or resampled"), std::string::npos);
    // A crop has its place still.
    changed.state = cropped(document.state, {0, 0, 400, 1580});
    const std::optional<io::PutBack> done = io::put_back(changed, {path("crop.vrt"), 0}, {});
    ASSERT_TRUE(done);
    EXPECT_EQ(done->changed, 16);
    EXPECT_FLOAT_EQ(
        level_of(io::TiledFile(path("crop.vrt"), {}), 0)[static_cast<std::size_t>(306) * whole_size.x + 206],
        hilly(206, 306) + 2);

    // Ended half way: nothing is there.
    EXPECT_FALSE(io::put_back(document, {path("ended.vrt"), 0}, [](double) { return false; }));
    EXPECT_FALSE(fs::exists(path("ended.vrt")));
    EXPECT_FALSE(fs::exists(path("ended.parts")));
    fs::rename(whole, path("gone.tif"));
    EXPECT_NE(refused(document).find("whole.tif"), std::string::npos);
}

}  // namespace
}  // namespace talus::cut_out_test
