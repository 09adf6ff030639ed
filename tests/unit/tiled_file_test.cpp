// Files in tiles: what is written is read again, whatever their size, and nothing else is believed.
#include <gtest/gtest.h>
#include <unistd.h>

#include <atomic>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <limits>
#include <random>

#include "sim/error.h"
#include "sim/io/atomic_file.h"
#include "sim/io/heightmap.h"
#include "sim/io/tile_sidecar.h"
#include "sim/io/tile_writer.h"
#include "tests/scenes/broken_file.h"
#include "tests/scenes/file_size_limit.h"
#include "tests/scenes/refusal.h"

namespace talus::tiled_file_test {
namespace {

namespace fs = std::filesystem;

using Overviews = io::TiledFile::Overviews;

constexpr float not_known = std::numeric_limits<float>::quiet_NaN();

// A source whose samples are a function of their places.
template <typename Height>
io::TiledSource source_of(glm::ivec2 size, Height height) {
    io::TiledSource source;
    source.grid = {size.x, size.y, 30, 20};
    source.make_reader = [height]() -> ReadSamples {
        return [height](int, const TileSamples& samples, std::vector<float>& heights) {
            heights.clear();
            for (int y = 0; y < samples.count.y; ++y)
                for (int x = 0; x < samples.count.x; ++x)
                    heights.push_back(height(samples.first.x + x, samples.first.y + y));
        };
    };
    return source;
}

// Hills with a little noise.
float hilly(int x, int y) {
    const auto mixed = static_cast<unsigned>(x) * 2654435761U ^ static_cast<unsigned>(y) * 2246822519U;
    return static_cast<float>(800 + 300 * std::sin(0.013 * x) * std::cos(0.021 * y) +
                              1e-3 * ((mixed >> 8) % 1000));
}

class TiledFiles : public ::testing::Test {
  protected:
    void SetUp() override { fs::create_directories(folder_); }
    void TearDown() override { fs::remove_all(folder_); }
    fs::path path(const std::string& name) const { return folder_ / name; }
    // Heights alone, without overviews.
    void write_plain(const std::string& name, glm::ivec2 size,
                     const std::function<float(int, int)>& height) const {
        io::Heightmap heightmap;
        heightmap.grid = {size.x, size.y, 30, 20};
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x) heightmap.heights.push_back(height(x, y));
        io::write_heightmap(path(name), heightmap, std::nullopt);
    }
    void write(const std::string& name, const std::string& content) const {
        std::ofstream(path(name), std::ios::binary) << content;
    }
    std::size_t files() const {
        return static_cast<std::size_t>(
            std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
    }
    std::string refusal(const std::string& name) const {
        return refusal_of(name, [&] {
            const io::TiledFile file(path(name), {});
            std::vector<float> heights;
            file.make_reader()(0, {glm::ivec2(0), glm::ivec2(file.grid().nx, file.grid().ny)}, heights);
        });
    }

    // A mosaic's description, of one file from its sample (0, 0) on; `place` and `nodata` are its elements.
    std::string mosaic(const std::string& part, glm::ivec2 size, const std::string& transform) const {
        return mosaic_at(part, size, "<GeoTransform>" + transform + "</GeoTransform>");
    }
    std::string mosaic_at(const std::string& part, glm::ivec2 size, const std::string& place,
                          const std::string& type = "Float32", const std::string& nodata = "") const {
        const std::string x = std::to_string(size.x);
        const std::string y = std::to_string(size.y);
        const std::string rectangle = "xOff=\"0\" yOff=\"0\" xSize=\"" + x + "\" ySize=\"" + y + "\"/>";
        return "<VRTDataset rasterXSize=\"" + x + "\" rasterYSize=\"" + y + "\">" + place +
               "<VRTRasterBand dataType=\"" + type + "\" band=\"1\">" + nodata +
               "<SimpleSource>"
               "<SourceFilename relativeToVRT=\"1\">" +
               part + "</SourceFilename><SourceBand>1</SourceBand><SrcRect " + rectangle + "<DstRect " +
               rectangle + "</SimpleSource></VRTRasterBand></VRTDataset>";
    }

  private:
    fs::path folder_ = fs::temp_directory_path() / ("talus_tiled_" + std::to_string(::getpid()));
};

std::vector<float> whole_level(const io::TiledFile& file, int level) {
    std::vector<float> heights;
    file.make_reader()(level, {glm::ivec2(0), file.levels()[static_cast<std::size_t>(level)]}, heights);
    return heights;
}

TEST_F(TiledFiles, HoldWhatWasWritten) {
    for (const glm::ivec2 size : {glm::ivec2(1300, 900), glm::ivec2(513, 2), glm::ivec2(2, 2)}) {
        ASSERT_TRUE(io::write_tiled(path("a.tif"), source_of(size, hilly), {}));
        const io::TiledFile file(path("a.tif"), {});
        EXPECT_EQ(file.grid(), (Grid{size.x, size.y, 30, 20}));
        EXPECT_LE(std::max(file.levels().back().x, file.levels().back().y), 256);
        const ReadSamples read = file.make_reader();
        std::mt19937 random(3);
        const auto any = [&](int below) { return static_cast<int>(random() % static_cast<unsigned>(below)); };
        std::vector<float> heights;
        for (int k = 0; k < 40; ++k) {
            // Partly beside the level, where the edge's samples stand.
            const glm::ivec2 first(any(size.x + 8) - 4, any(size.y + 8) - 4);
            const glm::ivec2 count(1 + any(300), 1 + any(300));
            read(0, {first, count}, heights);
            ASSERT_EQ(heights.size(), static_cast<std::size_t>(count.x) * count.y);
            for (int y = 0; y < count.y; y += 7)
                for (int x = 0; x < count.x; ++x) {
                    const glm::ivec2 at = glm::clamp(first + glm::ivec2(x, y), glm::ivec2(0), size - 1);
                    ASSERT_EQ(heights[static_cast<std::size_t>(y) * count.x + x], hilly(at.x, at.y));
                }
        }
    }
}

// Each level is the mean of the one before, also where a file is wider and higher than what is written at a
// time.
TEST_F(TiledFiles, HoldLevelsOfMeans) {
    for (const glm::ivec2 size :
         {glm::ivec2(1300, 901), glm::ivec2(33500, 70), glm::ivec2(45, 33500), glm::ivec2(600, 513)}) {
        ASSERT_TRUE(io::write_tiled(path("a.tif"), source_of(size, hilly), {}));
        const io::TiledFile file(path("a.tif"), {});
        ASSERT_EQ(file.levels().front(), size);
        ASSERT_GE(file.levels().size(), 3U);
        std::vector<float> finer = whole_level(file, 0);
        for (int level = 1; level < static_cast<int>(file.levels().size()); ++level) {
            const glm::ivec2 below = file.levels()[static_cast<std::size_t>(level) - 1];
            const glm::ivec2 here = file.levels()[static_cast<std::size_t>(level)];
            EXPECT_EQ(here, (below + 1) / 2);
            std::vector<float> coarser = whole_level(file, level);
            for (int y = 0; y < here.y; ++y)
                for (int x = 0; x < here.x; ++x) {
                    double sum = 0;
                    for (int k = 0; k < 4; ++k) {
                        const glm::ivec2 at =
                            glm::min(2 * glm::ivec2(x, y) + glm::ivec2(k % 2, k / 2), below - 1);
                        sum += finer[static_cast<std::size_t>(at.y) * below.x + at.x];
                    }
                    ASSERT_NEAR(coarser[static_cast<std::size_t>(y) * here.x + x], sum / 4, 2e-4)
                        << size.x << " x " << size.y << " level " << level << " at " << x << ", " << y;
                }
            finer = std::move(coarser);
        }
    }
}

TEST_F(TiledFiles, KeepWholeNumbersAndRows) {
    io::TiledSource source = source_of(
        {700, 530}, [](int x, int y) { return static_cast<float>((x * 31 + y * 17) % 4000 - 500); });
    source.samples = io::SampleType::int16;
    // By rows and by tiles alike.
    for (const bool in_rows : {false, true}) {
        source.in_rows = in_rows;
        ASSERT_TRUE(io::write_tiled(path("a.tif"), source, {}));
        const io::TiledFile file(path("a.tif"), {});
        EXPECT_EQ(file.kind(), "GTiff, Int16");
        const std::vector<float> heights = whole_level(file, 0);
        std::size_t i = 0;
        for (int y = 0; y < 530; ++y)
            for (int x = 0; x < 700; ++x)
                ASSERT_EQ(heights[i++], static_cast<float>((x * 31 + y * 17) % 4000 - 500));
    }
}

// What is not known stays so in the file, and lies among what is around it where heights are needed.
TEST_F(TiledFiles, FillWhatIsNotKnown) {
    const auto in_hole = [](int x, int y) { return x > 300 && x < 700 && y > 200 && y < 450; };
    io::TiledSource source =
        source_of({1000, 800}, [=](int x, int y) { return in_hole(x, y) ? not_known : hilly(x, y); });
    source.void_value = -9999;
    ASSERT_TRUE(io::write_tiled(path("a.tif"), source, {}));
    const io::TiledFile file(path("a.tif"), {});
    std::vector<float> raw;
    file.source().make_reader()(0, {glm::ivec2(0), glm::ivec2(1000, 800)}, raw);
    const std::vector<float> filled = whole_level(file, 0);
    float jump = 0;
    for (int y = 0; y < 800; ++y)
        for (int x = 0; x < 1000; ++x) {
            const std::size_t i = static_cast<std::size_t>(y) * 1000 + x;
            ASSERT_EQ(std::isnan(raw[i]), in_hole(x, y));
            if (!in_hole(x, y)) {
                ASSERT_EQ(filled[i], hilly(x, y));
            }
            ASSERT_TRUE(filled[i] > 490 && filled[i] < 1110) << filled[i];
            if (x > 0) jump = std::max(jump, std::abs(filled[i] - filled[i - 1]));
        }
    std::printf("largest step beside and in the hole: %.1f m\n", jump);
    // A cliff down to the value that stands for nothing would be thousands high.
    EXPECT_LT(jump, 50);
    const TileTree tree(file.grid(), 128, file.levels(), file.level_places());
    for (const TileBounds& one : measure_tile_bounds(tree, [&] { return file.make_reader(); })) {
        EXPECT_GT(one.lowest_m, 490);
        EXPECT_LT(one.highest_m, 1110);
    }
    source = source_of({600, 600}, [](int, int) { return not_known; });
    source.void_value = -9999;
    ASSERT_TRUE(io::write_tiled(path("nothing.tif"), source, {}));
    EXPECT_NE(refusal("nothing.tif").find("nodata"), std::string::npos);
}

TEST_F(TiledFiles, AreReadFromMosaicsAndTurnedNorthwards) {
    ASSERT_TRUE(io::write_tiled(path("part.tif"), source_of({640, 480}, hilly), {}));
    write("north.vrt", mosaic("part.tif", {640, 480}, "500000, 30, 0, 4000000, 0, -30"));
    write("south.vrt", mosaic("part.tif", {640, 480}, "500000, 30, 0, 4000000, 0, 30"));
    write("west.vrt", mosaic("part.tif", {640, 480}, "500000, -30, 0, 4000000, 0, -30"));
    const std::vector<float> north = whole_level(io::TiledFile(path("north.vrt"), {}), 0);
    const io::TiledFile south(path("south.vrt"), {});
    const io::TiledFile west(path("west.vrt"), {});
    const std::vector<float> from_south = whole_level(south, 0);
    const std::vector<float> from_west = whole_level(west, 0);
    for (int y = 0; y < 480; ++y)
        for (int x = 0; x < 640; ++x) {
            const std::size_t i = static_cast<std::size_t>(y) * 640 + x;
            ASSERT_EQ(north[i], hilly(x, y));
            ASSERT_EQ(from_south[i], hilly(x, 479 - y));
            ASSERT_EQ(from_west[i], hilly(639 - x, y));
        }
    // As the turned file lies.
    ASSERT_TRUE(south.georeference());
    EXPECT_EQ(south.georeference()->transform[3], 4000000 + 480 * 30);
    EXPECT_EQ(south.georeference()->transform[5], -30);
    ASSERT_TRUE(io::write_tiled(path("turned.tif"), south.source(), {}));
    const io::TiledFile turned(path("turned.tif"), {});
    EXPECT_EQ(whole_level(turned, 0), from_south);
    EXPECT_EQ(turned.georeference()->transform, south.georeference()->transform);
    write("lost.vrt", mosaic("gone.tif", {640, 480}, "500000, 30, 0, 4000000, 0, -30"));
    refusal("lost.vrt");
}

TEST_F(TiledFiles, RefuseWhatIsNoTerrain) {
    write("text.tif", "this is no raster");
    refusal("text.tif");
    refusal("absent.tif");
    write("thin.asc", "ncols 1\nnrows 3\nxllcorner 0\nyllcorner 0\ncellsize 1\n1\n2\n3\n");
    EXPECT_NE(refusal("thin.asc").find("at least 2"), std::string::npos);
    ASSERT_TRUE(io::write_tiled(path("whole.tif"), source_of({1500, 1500}, hilly), {}));
    const std::string content = io::read_text(path("whole.tif"));
    // Cut where heights are: what is there is read, the rest is refused.
    write("cut.tif", content.substr(0, content.size() / 2));
    refusal("cut.tif");
    io::TiledSource source =
        source_of({600, 600}, [](int x, int y) { return x == 300 && y == 20 ? not_known : 5; });
    ASSERT_TRUE(io::write_tiled(path("unsound.tif"), source, {}));
    EXPECT_NE(refusal("unsound.tif").find("not finite"), std::string::npos);
}

// Until all is written the name keeps what it had, and nothing is left beside it.
TEST_F(TiledFiles, LeaveNoHalfFile) {
    write("a.tif", "what was there");
    int told = 0;
    const io::TiledSource large = source_of({3000, 3000}, hilly);
    EXPECT_FALSE(io::write_tiled(path("a.tif"), large, [&](double share) {
        EXPECT_GT(share, 0);
        EXPECT_LE(share, 1);
        return ++told < 3;
    }));
    EXPECT_EQ(told, 3);
    EXPECT_EQ(io::read_text(path("a.tif")), "what was there");
    EXPECT_EQ(files(), 1U);
    io::TiledSource broken = large;
    broken.make_reader = [] {
        return [](int, const TileSamples& samples, std::vector<float>& heights) {
            if (samples.first.y > 1000) throw Error("the source is gone");
            heights.assign(static_cast<std::size_t>(samples.count.x) * samples.count.y, 1);
        };
    };
    EXPECT_THROW(io::write_tiled(path("a.tif"), broken, {}), Error);
    EXPECT_EQ(io::read_text(path("a.tif")), "what was there");
    EXPECT_EQ(files(), 1U);
    // No space: as a limit on a file's size has it.
    std::string said;
    try {
        const FileSizeLimit limit(300000);
        ASSERT_TRUE(limit.is_set());
        io::write_tiled(path("a.tif"), large, {});
    } catch (const Error& error) {
        said = error.what();
    }
    EXPECT_NE(said.find("cannot write"), std::string::npos) << said;
    EXPECT_NE(said.find("a.tif"), std::string::npos) << said;
    EXPECT_EQ(io::read_text(path("a.tif")), "what was there");
    EXPECT_EQ(files(), 1U);
    EXPECT_TRUE(io::write_tiled(path("a.tif"), large, {}));
    EXPECT_THROW(io::write_tiled(path("nowhere/a.tif"), large, {}), Error);
}

// Bounds are believed of the file that they were measured of alone, and of no damaged sidecar.
TEST_F(TiledFiles, KnowTheirBounds) {
    ASSERT_TRUE(io::write_tiled(path("a.tif"), source_of({1100, 700}, hilly), {}));
    const io::TiledFile file(path("a.tif"), {});
    const TileTree tree(file.grid(), 64, file.levels(), file.level_places());
    EXPECT_FALSE(io::read_tile_sidecar(file, tree));
    const auto bounds = measure_tile_bounds(tree, [&] { return file.make_reader(); });
    io::write_tile_sidecar(file, tree, bounds);
    ASSERT_TRUE(io::read_tile_sidecar(file, tree));
    EXPECT_EQ(*io::read_tile_sidecar(file, tree), bounds);
    EXPECT_EQ(*io::read_tile_sidecar(io::TiledFile(path("a.tif"), {}), tree), bounds);
    EXPECT_FALSE(io::read_tile_sidecar(file, TileTree(file.grid(), 128, file.levels(), file.level_places())));

    const std::string sound = io::read_text(io::tile_sidecar_path(path("a.tif")));
    std::mt19937 random(5);
    for (int k = 0; k < 400; ++k) {
        std::string damaged = sound;
        if (k % 4 == 0)
            damaged.resize(random() % damaged.size());
        else
            for (unsigned i = 0; i <= random() % 3; ++i)
                damaged[random() % damaged.size()] ^= static_cast<char>(1 + random() % 255);
        if (k % 50 == 0) damaged += "more";
        write("a.tif.tiles", damaged);
        const auto read = io::read_tile_sidecar(file, tree);
        ASSERT_TRUE(!read || damaged == sound) << k;
    }
    write("a.tif.tiles", sound);
    EXPECT_TRUE(io::read_tile_sidecar(file, tree));
    // Other content of the same size.
    ASSERT_TRUE(
        io::write_tiled(path("a.tif"), source_of({1100, 700}, [](int x, int y) { return hilly(y, x); }), {}));
    EXPECT_FALSE(io::read_tile_sidecar(io::TiledFile(path("a.tif"), {}), tree));
}

// Bounds belong to content: to no spelling of a path, and to the parts of parts too.
TEST_F(TiledFiles, KnowTheirPartsHoweverTheyAreNamed) {
    ASSERT_TRUE(io::write_tiled(path("part.tif"), source_of({640, 480}, hilly), {}));
    write("inner.vrt", mosaic("part.tif", {640, 480}, "0, 30, 0, 0, 0, -30"));
    write("outer.vrt", mosaic("inner.vrt", {640, 480}, "0, 30, 0, 0, 0, -30"));
    const auto fingerprint = [&](const std::string& name) {
        return io::TiledFile(path(name), {}).fingerprint();
    };
    const std::uint64_t part = fingerprint("part.tif");
    const std::uint64_t outer = fingerprint("outer.vrt");
    EXPECT_EQ(fingerprint("./part.tif"), part);
    EXPECT_EQ(fingerprint("../" + path("").parent_path().filename().string() + "/part.tif"), part);
    EXPECT_EQ(fingerprint("./outer.vrt"), outer);
    const fs::path before = fs::current_path();
    fs::current_path(path(""));
    EXPECT_EQ(io::TiledFile("part.tif", {}).fingerprint(), part);
    EXPECT_EQ(io::TiledFile("outer.vrt", {}).fingerprint(), outer);
    fs::current_path(before);
    const io::TiledFile file(path("outer.vrt"), {});
    EXPECT_TRUE(io::is_made_of(file.path(), path("outer.vrt")));
    EXPECT_TRUE(io::is_made_of(file.path(), path("inner.vrt")));
    EXPECT_FALSE(io::is_made_of(file.path(), path("other.tif")));
    EXPECT_FALSE(file.has_changed());
    ASSERT_TRUE(io::write_tiled(path("part.tif"),
                                source_of({640, 480}, [](int x, int y) { return hilly(y, x); }), {}));
    EXPECT_NE(fingerprint("outer.vrt"), outer);
    EXPECT_TRUE(file.has_changed());
    // What is not there cannot be asked.
    fs::remove(path("outer.vrt"));
    EXPECT_FALSE(file.has_changed());
}

// Known heights stay known, whatever number stands for what is not.
TEST_F(TiledFiles, KeepVoidsApart) {
    const auto either_side = [](int x, int y) {
        return x < 20 ? not_known : (x + y) % 2 == 0 ? 1.0F : -1.0F;
    };
    for (const io::SampleType samples : {io::SampleType::int16, io::SampleType::float32})
        for (const float void_value : {0.0F, -32768.0F, 255.0F}) {
            io::TiledSource source = source_of({700, 300}, either_side);
            source.samples = samples;
            source.void_value = void_value;
            ASSERT_TRUE(io::write_tiled(path("a.tif"), source, {}));
            const io::TiledFile file(path("a.tif"), {});
            std::vector<float> heights;
            file.source().make_reader()(0, {glm::ivec2(0), glm::ivec2(700, 300)}, heights);
            for (std::size_t i = 0; i < heights.size(); ++i)
                ASSERT_EQ(std::isnan(heights[i]), i % 700 < 20) << void_value;
            // Means of 1 and -1 are 0.
            file.source().make_reader()(1, {glm::ivec2(0), glm::ivec2(350, 150)}, heights);
            for (std::size_t i = 0; i < heights.size(); ++i) {
                ASSERT_EQ(std::isnan(heights[i]), i % 350 < 10) << void_value;
                if (!std::isnan(heights[i])) {
                    ASSERT_LE(std::abs(heights[i]), 1);
                }
            }
        }
    io::TiledSource source = source_of({300, 300}, either_side);
    source.void_value = not_known;
    ASSERT_TRUE(io::write_tiled(path("a.tif"), source, {}));
    for (const float h : whole_level(io::TiledFile(path("a.tif"), {}), 0)) ASSERT_TRUE(std::isfinite(h));
}

// Overviews beside a raster: those that it would have as a file in tiles, and it keeps its bytes.
TEST_F(TiledFiles, HaveOverviewsMadeBesideThem) {
    for (const glm::ivec2 size : {glm::ivec2(1301, 900), glm::ivec2(700, 2), glm::ivec2(300, 1100)}) {
        write_plain("a.tif", size, hilly);
        ASSERT_TRUE(io::write_tiled(path("b.tif"), source_of(size, hilly), {}));
        const io::TiledFile tiles(path("b.tif"), {});
        const io::TiledFile before(path("a.tif"), {});
        const std::string bytes = io::read_text(path("a.tif"));
        ASSERT_EQ(before.levels().size(), 1U);
        EXPECT_EQ(before.overviews(), Overviews::none);
        double told = 0;
        ASSERT_TRUE(io::write_overviews(before, [&](double share) {
            EXPECT_GT(share, told);
            told = share;
            return true;
        }));
        EXPECT_NEAR(told, 1, 1e-9);
        const io::TiledFile file(path("a.tif"), {});
        EXPECT_EQ(file.overviews(), Overviews::some);
        EXPECT_EQ(file.levels(), tiles.levels());
        EXPECT_EQ(file.level_places(), LevelPlaces::by_halves);
        for (int level = 0; level < static_cast<int>(tiles.levels().size()); ++level)
            EXPECT_EQ(whole_level(file, level), whole_level(tiles, level)) << level;
        EXPECT_EQ(io::read_text(path("a.tif")), bytes);
        // What was cut out of it was cut out of the same; bounds of its tiles are others.
        EXPECT_EQ(file.fingerprint(), before.fingerprint());
        EXPECT_NE(file.levels_fingerprint(), before.levels_fingerprint());
        EXPECT_TRUE(io::is_made_of(file.path(), io::overviews_path(path("a.tif"))));
        fs::remove(io::overviews_path(path("a.tif")));
    }
}

// A sample of an overview is the mean of four heights, whichever way a file stores them.
TEST_F(TiledFiles, HaveOverviewsOfWhatTheyStore) {
    const glm::ivec2 size(901, 703);
    const auto whole_number = [](int x, int y) { return std::round(hilly(x, y)); };
    write_plain("part.tif", size, whole_number);
    const auto placed = [](const std::string& transform) {
        return "<GeoTransform>" + transform + "</GeoTransform>";
    };
    struct Case {
        std::string place;
        std::string type;
        std::string nodata;
        double step_m;  // between the heights that a sample can have
    };
    const std::string north_up = placed("100, 30, 0, 7000, 0, -20");
    const double picture_step_m = 899.0 / 8 / 65535;
    for (const Case& one :
         {Case{north_up, "Int16", "", 1}, Case{placed("100, 30, 0, 7000, 0, 20"), "Float32", "", 0},
          Case{placed("100, -30, 0, 7000, 0, -20"), "Int16", "<NoDataValue>801</NoDataValue>", 1},
          Case{north_up, "UInt16", "<Scale>0.5</Scale>", 1}, Case{north_up, "Float64", "", 0},
          Case{"", "UInt16", "", picture_step_m}}) {
        write("a.vrt", mosaic_at("part.tif", size, one.place, one.type, one.nodata));
        ASSERT_TRUE(io::write_overviews(io::TiledFile(path("a.vrt"), {}), {}));
        const io::TiledFile file(path("a.vrt"), {});
        ASSERT_EQ(file.levels().size(), 3U);
        const std::vector<float> finest = whole_level(file, 0);
        std::vector<float> raw;
        file.source().make_reader()(0, {glm::ivec2(0), size}, raw);
        const std::vector<float> half = whole_level(file, 1);
        const glm::ivec2 half_size = file.levels()[1];
        ASSERT_EQ(half_size, (size + 1) / 2);
        // The file's first samples are averaged together; the one that is left over is its last.
        const bool turned_x = one.place.find("-30") != std::string::npos;
        const bool turned_y = one.place.find(", 20<") != std::string::npos;
        for (int y = 0; y < half_size.y; ++y)
            for (int x = 0; x < half_size.x; ++x) {
                double sum = 0;
                bool known = true;
                for (int k = 0; k < 4; ++k) {
                    const glm::ivec2 from = 2 * glm::ivec2(x, y) - glm::ivec2(turned_x, turned_y);
                    const glm::ivec2 at =
                        glm::clamp(from + glm::ivec2(k % 2, k / 2), glm::ivec2(0), size - 1);
                    const auto i = static_cast<std::size_t>(at.y) * size.x + at.x;
                    sum += finest[i];
                    known = known && !std::isnan(raw[i]);
                }
                if (!known) continue;
                // A mean that is the number for voids is moved to the next one.
                const double room = one.step_m / 2 + (one.nodata.empty() ? 0 : one.step_m);
                ASSERT_NEAR(half[static_cast<std::size_t>(y) * half_size.x + x], sum / 4, room + 1e-4)
                    << one.place << one.type << " " << x << ", " << y;
            }
        fs::remove(path("a.vrt.ovr"));
    }
}

// Overviews that were made of what a file held before are not believed, and are made again.
TEST_F(TiledFiles, HaveOverviewsOfWhatTheyHold) {
    const auto changed = [](int x, int y) { return 2 * hilly(x, y); };
    write_plain("part.tif", {900, 700}, hilly);
    write("a.vrt", mosaic("part.tif", {900, 700}, "100, 30, 0, 7000, 0, -20"));
    for (const char* const name : {"part.tif", "a.vrt"}) {
        ASSERT_TRUE(io::write_overviews(io::TiledFile(path(name), {}), {}));
        EXPECT_EQ(io::TiledFile(path(name), {}).overviews(), Overviews::some);
        // Of the same samples, however they are read.
        io::ImportSettings spread;
        spread.spacing_m = 7;
        EXPECT_EQ(io::TiledFile(path(name), spread).overviews(), Overviews::some);
    }
    // A copy of both files has them too.
    fs::create_directory(path("copy"));
    for (const char* const name : {"part.tif", "part.tif.ovr"})
        fs::copy_file(path(name), path("copy") / name);
    EXPECT_EQ(io::TiledFile(path("copy") / "part.tif", {}).overviews(), Overviews::some);
    write_plain("part.tif", {900, 700}, changed);
    for (const char* const name : {"part.tif", "a.vrt"}) {
        const io::TiledFile before(path(name), {});
        EXPECT_EQ(before.overviews(), Overviews::outdated);
        EXPECT_EQ(before.levels().size(), 1U);
        ASSERT_TRUE(io::write_overviews(before, {}));
        const io::TiledFile file(path(name), {});
        EXPECT_EQ(file.overviews(), Overviews::some);
        ASSERT_EQ(file.levels().size(), 3U);
        EXPECT_GT(whole_level(file, 2).front(), 1.5F * hilly(0, 0));
    }
}

// Overviews of the first band alone, or of numbers that are none, would mislead who reads them.
TEST_F(TiledFiles, SayWhyTheyHaveNoOverviews) {
    write_plain("part.tif", {900, 700}, hilly);
    const std::string place = "<GeoTransform>100, 30, 0, 7000, 0, -20</GeoTransform>";
    const auto why = [&](const std::string& type, const std::string& element) {
        write("a.vrt", mosaic_at("part.tif", {900, 700}, place, type, element));
        return io::TiledFile(path("a.vrt"), {}).why_no_overviews();
    };
    EXPECT_EQ(why("Float32", ""), "");
    EXPECT_EQ(why("Float64", "<NoDataValue>-9999</NoDataValue>"), "");
    EXPECT_NE(why("Float64", "<NoDataValue>-1.7976931348623157e+308</NoDataValue>"), "");
    EXPECT_NE(why("Byte",
                  "<ColorInterp>Palette</ColorInterp><ColorTable><Entry c1=\"0\" c2=\"0\" "
                  "c3=\"0\" c4=\"255\"/></ColorTable>"),
              "");
    const std::string one = mosaic_at("part.tif", {900, 700}, place);
    const std::size_t begin = one.find("<VRTRasterBand");
    const std::string band = one.substr(begin, one.find("</VRTDataset>") - begin);
    std::string second = band;
    second.replace(second.find("band=\"1\""), 8, "band=\"2\"");
    write("b.vrt", one.substr(0, begin) + band + second + "</VRTDataset>");
    EXPECT_NE(io::TiledFile(path("b.vrt"), {}).why_no_overviews(), "");
}

// A raster whose name ends as overviews' do is watched as any other.
TEST_F(TiledFiles, MayBeNamedAsOverviewsAre) {
    write_plain("a.tif", {900, 700}, hilly);
    fs::rename(path("a.tif"), path("a.ovr"));
    const io::TiledFile file(path("a.ovr"), {});
    write_plain("a.tif", {901, 700}, hilly);
    fs::rename(path("a.tif"), path("a.ovr"));
    EXPECT_TRUE(file.has_changed());
    EXPECT_NE(io::TiledFile(path("a.ovr"), {}).fingerprint(), file.fingerprint());
}

// What a program left that was killed while it wrote goes when the file is written again; what another one
// writes does not.
TEST_F(TiledFiles, ClearAwayWhatWasLeft) {
    write(".a.tif.talus-abcdef", "half of a file");
    write(".a.tif.backup", "somebody's");
    const io::AtomicFile other(path("a.tif"));
    ASSERT_TRUE(io::write_tiled(path("a.tif"), source_of({300, 300}, hilly), {}));
    EXPECT_FALSE(fs::exists(path(".a.tif.talus-abcdef")));
    EXPECT_TRUE(fs::exists(path(".a.tif.backup")));
    EXPECT_TRUE(fs::exists(other.temporary()));
    EXPECT_EQ(files(), 3U);
}

// What cannot be finished leaves nothing behind.
TEST_F(TiledFiles, HaveNoHalfOverviews) {
    write_plain("a.tif", {3000, 1100}, hilly);
    const io::TiledFile file(path("a.tif"), {});
    EXPECT_FALSE(io::write_overviews(file, [](double share) { return share < 0.3; }));
    EXPECT_EQ(files(), 1U);
    EXPECT_EQ(io::TiledFile(path("a.tif"), {}).overviews(), Overviews::none);
    std::string said;
    try {
        const FileSizeLimit limit(30000);
        ASSERT_TRUE(limit.is_set());
        io::write_overviews(file, {});
    } catch (const Error& error) {
        said = error.what();
    }
    EXPECT_NE(said.find("cannot write '" + path("a.tif.ovr").string()), std::string::npos) << said;
    EXPECT_EQ(files(), 1U);
}

// A level that is a single block of the file too.
TEST_F(TiledFiles, AreReadAgainWhenTheyComeBack) {
    ASSERT_TRUE(io::write_tiled(path("a.tif"), source_of({700, 600}, hilly), [](double) { return true; }));
    const io::TiledFile file(path("a.tif"), {});
    auto read = [reader = file.make_reader()](int level) mutable {
        std::vector<float> heights;
        reader(level, {glm::ivec2(20), glm::ivec2(200)}, heights);
        return heights;
    };
    std::vector<float> half;
    file.make_reader()(1, {glm::ivec2(20), glm::ivec2(200)}, half);
    scenes::BrokenFile broken(path("a.tif"));
    EXPECT_THROW(read(1), Error);
    EXPECT_THROW(read(1), Error);
    broken.mend();
    EXPECT_EQ(read(1), half);
}

}  // namespace
}  // namespace talus::tiled_file_test
