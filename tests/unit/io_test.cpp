// Files: round trips to the bit, guesses, and damaged or hostile input refused in one sentence.
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <random>
#include <thread>

#include "app/core/scene.h"
#include "sim/error.h"
#include "sim/io/atomic_file.h"
#include "sim/io/colour_image.h"
#include "sim/io/document.h"
#include "sim/io/endings.h"
#include "sim/io/heightmap.h"
#include "sim/terrain/state_hash.h"
#include "tests/scenes/refusal.h"

namespace talus::io_test {
namespace {

namespace fs = std::filesystem;

class Files : public ::testing::Test {
  protected:
    void SetUp() override { fs::create_directories(folder_); }
    void TearDown() override { fs::remove_all(folder_); }
    fs::path path(const std::string& name) const { return folder_ / name; }
    void write(const std::string& name, const std::string& content) const {
        std::ofstream(path(name), std::ios::binary) << content;
    }

    // One sentence: no line breaks, names the file, not a word of it twice the same.
    std::string refusal(const std::string& name, const io::ImportSettings& settings = {}) const {
        return refusal_of(name, [&] { io::open_document(path(name), settings); });
    }

  private:
    fs::path folder_ = fs::temp_directory_path() / ("talus_files_" + std::to_string(::getpid()));
};

io::Heightmap rough(int nx, int ny) {
    io::Heightmap heightmap;
    heightmap.grid = {nx, ny, 30, 20};
    std::mt19937 random(7);
    std::normal_distribution<float> normal(1500, 400);
    heightmap.heights.resize(heightmap.grid.count());
    for (float& h : heightmap.heights) h = normal(random);
    return heightmap;
}

TEST_F(Files, FloatsRoundTripToTheBitThroughEveryFloatFormat) {
    const io::Heightmap original = rough(77, 53);
    io::write_heightmap(path("a.tif"), original, std::nullopt);
    io::Heightmap step = io::read_heightmap(path("a.tif"), {});
    EXPECT_EQ(step.heights, original.heights);
    EXPECT_EQ(step.grid, original.grid);
    write_heightmap(path("b.exr"), step, std::nullopt);
    step = io::read_heightmap(path("b.exr"), {});
    EXPECT_EQ(step.heights, original.heights);
    write_heightmap(path("c.r32"), step, std::nullopt);
    step = io::read_heightmap(path("c.r32"), {});
    EXPECT_EQ(step.grid, original.grid);
    write_heightmap(path("d.tif"), step, std::nullopt);
    step = io::read_heightmap(path("d.tif"), {});
    EXPECT_EQ(step.heights, original.heights);
    EXPECT_EQ(step.grid, original.grid);
}

TEST_F(Files, ANameWithoutAKnownEndingIsCompleted) {
    for (const auto& [given, wanted] : {std::pair{"ridge", "ridge.exr"},
                                        {"ridge.v2", "ridge.v2.exr"},
                                        {"1.5m", "1.5m.exr"},
                                        {"a.b/ridge", "a.b/ridge.exr"},
                                        {"ridge.", "ridge.exr"},
                                        {"ridge.EXR", "ridge.EXR"},
                                        {"ridge.tif", "ridge.tif"},
                                        {"ridge.r16", "ridge.r16"},
                                        {"ridge.obj", "ridge.obj"},
                                        {"ridge.jpeg", "ridge.jpeg"},
                                        {"ridge.f", "ridge.f.exr"}})
        EXPECT_EQ(io::with_ending(given, ".exr"), fs::path(wanted));
    for (const char* no_file : {"", ".", "..", "a/b/", "/", "a/.."})
        EXPECT_EQ(io::with_ending(no_file, ".exr"), fs::path(no_file));
    for (const auto& [given, wanted] : {std::pair{"ridge.v2", "ridge.v2.obj"},
                                        {"ridge.v2.tif", "ridge.v2.obj"},
                                        {"ridge", "ridge.obj"},
                                        {"ridge.obj", "ridge.obj"}})
        EXPECT_EQ(io::with_other_ending(given, ".obj"), fs::path(wanted));
}

TEST_F(Files, IntegersComeBackWithinHalfAStep) {
    const io::Heightmap original = rough(64, 48);
    const auto [low, high] = std::minmax_element(original.heights.begin(), original.heights.end());
    // Half a step, and half an ulp of the float that the height comes back as.
    const double half_step = (*high - *low) / 65535.0 / 2 + 0.5 * (std::nextafter(*high, HUGE_VALF) - *high);
    for (const char* name : {"a.png", "a.r16"}) {
        io::write_heightmap(path(name), original, std::nullopt);
        const io::Heightmap back = io::read_heightmap(path(name), {});
        EXPECT_EQ(back.grid, original.grid) << name;
        double worst = 0;
        for (std::size_t i = 0; i < back.heights.size(); ++i)
            worst = std::max(worst, std::abs(static_cast<double>(back.heights[i]) - original.heights[i]));
        EXPECT_LE(worst, half_step) << name;
        EXPECT_GT(worst, 0) << name;
    }
    // The range travels inside the PNG too, for when the sidecar is lost.
    fs::remove(path("a.png.json"));
    const io::Heightmap alone = io::read_heightmap(path("a.png"), {});
    EXPECT_NEAR(alone.heights[100], original.heights[100], half_step + 1e-3);
    EXPECT_EQ(alone.grid.dx, 30);
}

TEST_F(Files, TheDocumentKeepsEveryBitAndTheClock) {
    io::Document document;
    document.state = bedrock_terrain({70, 41, 12.5, 8}, std::vector<float>(70 * 41, 1000.0F));
    std::mt19937 random(3);
    std::uniform_real_distribution<float> small(-1e-5F, 1e-5F);
    for (std::size_t i = 0; i < document.state.bedrock.size(); ++i) {
        document.state.bedrock[i] += glm::vec2(small(random) * 1e6F, small(random));
        document.state.regolith[i] = glm::vec2(small(random) + 1e-5F, small(random) * 1e-7F);
    }
    document.state.clock = {1234567, 0.1 + 0.2};
    document.parameters = "[thermal]\nrepose_deg = 31.0\n";
    document.state.georeference = Georeference{"", {500000.25, 12.5, 0, 4000000.125, 0, -8}};
    io::save_document(path("d.exr"), document);
    const io::Document back = io::open_document(path("d.exr"), {});
    EXPECT_EQ(state_hash(back.state), state_hash(document.state));
    EXPECT_EQ(back.parameters, document.parameters);
    EXPECT_EQ(back.state.georeference, document.state.georeference);
    EXPECT_EQ(back.state.clock, document.state.clock);
}

TEST_F(Files, RawSizeAndByteOrderAreGuessedAndSaid) {
    io::Heightmap smooth;
    smooth.grid = {65, 65, 1, 1};
    for (int row = 0; row < 65; ++row)
        for (int column = 0; column < 65; ++column)
            smooth.heights.push_back(static_cast<float>(100 + column + row));
    io::write_heightmap(path("a.r16"), smooth, glm::dvec2(0, 65535));
    std::string bytes = io::read_text(path("a.r16"));
    for (std::size_t i = 0; i + 1 < bytes.size(); i += 2) std::swap(bytes[i], bytes[i + 1]);
    write("big.r16", bytes);
    io::ImportSettings settings;
    settings.range_m = glm::dvec2(0, 65535);
    const io::Heightmap guessed = read_heightmap(path("big.r16"), settings);
    EXPECT_EQ(guessed.heights, smooth.heights);
    ASSERT_EQ(guessed.notes.size(), 3U);
    EXPECT_NE(guessed.notes[0].find("65 x 65"), std::string::npos);
    EXPECT_NE(guessed.notes[1].find("big"), std::string::npos);
    settings.raw = io::parse_raw_layout("65x65,big,bottom");
    const io::Heightmap turned = read_heightmap(path("big.r16"), settings);
    EXPECT_EQ(turned.heights[0], smooth.heights[64 * 65]);
    EXPECT_THROW(io::parse_raw_layout("65by65"), Error);
    EXPECT_THROW(io::parse_raw_layout("65x65,middle"), Error);
}

// Bytes that make no height in either order say nothing of the order.
TEST_F(Files, NaNsAreNoEvidenceForTheOtherByteOrder) {
    const auto bytes_of = [](const std::vector<float>& heights, bool big) {
        std::string bytes(heights.size() * sizeof(float), '\0');
        std::memcpy(bytes.data(), heights.data(), bytes.size());
        for (std::size_t i = 0; big && i < bytes.size(); i += 4) {
            std::swap(bytes[i], bytes[i + 3]);
            std::swap(bytes[i + 1], bytes[i + 2]);
        }
        return bytes;
    };
    for (const bool big : {false, true}) {
        write("nan.r32", bytes_of(std::vector<float>(33 * 33, std::nanf("")), big));
        EXPECT_NE(refusal("nan.r32").find("in either byte order"), std::string::npos);
        // A few of them among heights, level ones and rough ones: of those that stand alone.
        for (const bool is_level : {true, false}) {
            std::vector<float> heights(33 * 33, 100);
            std::mt19937 random(5);
            std::uniform_real_distribution<float> spread(-500, 4000);
            if (!is_level)
                for (float& height : heights) height = spread(random);
            write("heights.r32", bytes_of(heights, big));
            EXPECT_EQ(io::read_heightmap(path("heights.r32"), {}).heights, heights) << big << is_level;
            heights[7] = heights[500] = std::nanf("");
            write("holes.r32", bytes_of(heights, big));
            EXPECT_NE(refusal("holes.r32").find(" 2 samples that are not finite"), std::string::npos);
        }
    }
}

TEST_F(Files, DeclaredNodataIsFilledAndCounted) {
    write("v.asc",
          "ncols 4\nnrows 3\nxllcorner 0\nyllcorner 0\ncellsize 10\nNODATA_value -9999\n"
          "1 2 3 4\n5 -9999 7 8\n9 10 11 -9999\n");
    const io::Heightmap filled = io::read_heightmap(path("v.asc"), {});
    EXPECT_EQ(filled.grid, (Grid{4, 3, 10, 10}));
    ASSERT_FALSE(filled.notes.empty());
    EXPECT_NE(filled.notes[0].find("2 void samples"), std::string::npos);
    EXPECT_GT(filled.heights[5], 2);
    EXPECT_LT(filled.heights[5], 10);
    write("only.asc",
          "ncols 2\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 10\nNODATA_value -9999\n-9999 -9999\n-9999 "
          "-9999\n");
    EXPECT_NE(refusal("only.asc").find("nothing but nodata"), std::string::npos);
}

TEST_F(Files, EsriBilIsReadWithItsHeader) {
    const std::vector<float> heights = {1.5F, -2, 3, 4, 5, 6};
    write("plain.bil", std::string(reinterpret_cast<const char*>(heights.data()), 4 * heights.size()));
    write(
        "plain.hdr",
        "NROWS 2\nNCOLS 3\nNBANDS 1\nNBITS 32\nPIXELTYPE FLOAT\nBYTEORDER I\nLAYOUT BIL\nULXMAP 0\nULYMAP 0\n"
        "XDIM 30\nYDIM 20\n");
    const io::Heightmap read = io::read_heightmap(path("plain.bil"), {});
    EXPECT_EQ(read.heights, heights);
    EXPECT_EQ(read.grid, (Grid{3, 2, 30, 20}));
    std::filesystem::remove(path("plain.hdr"));
    EXPECT_NE(refusal("plain.bil").find("plain.bil"), std::string::npos);
}

// Heights without a sign that lie somewhere are metres, and no picture's brightness.
TEST_F(Files, WholeMetresOfAPlacedFileAreNotStretched) {
    const std::vector<std::uint16_t> heights = {100, 200, 300, 400, 500, 1234};
    write("whole.bil", std::string(reinterpret_cast<const char*>(heights.data()), 2 * heights.size()));
    write("whole.hdr",
          "NROWS 2\nNCOLS 3\nNBANDS 1\nNBITS 16\nBYTEORDER I\nLAYOUT BIL\nULXMAP 500\nULYMAP 900\nXDIM "
          "30\nYDIM "
          "20\n");
    EXPECT_EQ(io::read_heightmap(path("whole.bil"), {}).heights,
              std::vector<float>(heights.begin(), heights.end()));
}

TEST_F(Files, VoidsFarFromAnySampleAreFilledToo) {
    std::string text = "ncols 12\nnrows 12\nxllcorner 0\nyllcorner 0\ncellsize 10\nNODATA_value -9999\n100";
    for (int i = 1; i < 144; ++i) text += " -9999";
    write("corner.asc", text + "\n");
    const io::Heightmap filled = io::read_heightmap(path("corner.asc"), {});
    for (const float h : filled.heights) EXPECT_EQ(h, 100);
}

TEST_F(Files, ASidecarIsNotBelievedOfOtherContent) {
    io::Heightmap low = rough(32, 32);
    io::Heightmap high = low;
    for (float& h : high.heights) h += 5000;
    for (const std::string name : {"a.png", "a.r16"}) {
        io::write_heightmap(path(name), low, std::nullopt);
        const std::string samples = io::read_text(path(name));
        io::write_heightmap(path(name), high, std::nullopt);
        write(name, samples);  // as after a kill between the two files
        const io::Heightmap back = io::read_heightmap(path(name), {});
        EXPECT_NE(back.notes.at(0).find("not used"), std::string::npos) << name;
        EXPECT_LT(*std::max_element(back.heights.begin(), back.heights.end()), 4500) << name;
    }
}

TEST_F(Files, SpacingGivenByHandDropsTheOldPlaceOnEarth) {
    io::Heightmap placed = rough(20, 20);
    placed.georeference = Georeference{"", {1000, 30, 0, 2000, 0, -20}};
    io::write_heightmap(path("g.tif"), placed, std::nullopt);
    io::ImportSettings settings;
    settings.spacing_m = 5;
    const io::Heightmap read = read_heightmap(path("g.tif"), settings);
    EXPECT_EQ(read.grid.dx, 5);
    write_heightmap(path("s.tif"), read, std::nullopt);
    EXPECT_EQ(io::read_heightmap(path("s.tif"), {}).grid.dx, 5);
}

// Files whose rows run northwards, or columns westwards, show the same terrain at the same place.
TEST_F(Files, RowsAndColumnsThatRunBackwardsAreTurnedRound) {
    io::Heightmap placed = rough(23, 17);
    const double width_m = placed.grid.nx * placed.grid.dx;
    const double height_m = placed.grid.ny * placed.grid.dy;
    placed.georeference = Georeference{"", {1000, 30, 0, 2000, 0, -20}};
    for (const bool northwards : {false, true})
        for (const bool westwards : {false, true}) {
            io::Heightmap stored = placed;
            for (int y = 0; y < stored.grid.ny; ++y)
                for (int x = 0; x < stored.grid.nx; ++x) {
                    const int row = northwards ? stored.grid.ny - 1 - y : y;
                    const int column = westwards ? stored.grid.nx - 1 - x : x;
                    stored.heights[static_cast<std::size_t>(y) * stored.grid.nx + x] =
                        placed.heights[static_cast<std::size_t>(row) * stored.grid.nx + column];
                }
            stored.georeference->transform = {westwards ? 1000 + width_m : 1000,
                                              westwards ? -30.0 : 30.0,
                                              0,
                                              northwards ? 2000 - height_m : 2000,
                                              0,
                                              northwards ? 20.0 : -20.0};
            io::write_heightmap(path("t.tif"), stored, std::nullopt);
            const io::Heightmap read = io::read_heightmap(path("t.tif"), {});
            EXPECT_EQ(read.heights, placed.heights) << northwards << westwards;
            EXPECT_EQ(read.georeference->transform, placed.georeference->transform)
                << northwards << westwards;
        }
}

TEST_F(Files, PipesAreWrittenIntoAndReadOnlyFilesAreNot) {
    ASSERT_EQ(::mkfifo(path("pipe").c_str(), 0600), 0);
    std::string got;
    std::thread reader([&] { got = io::read_text(path("pipe")); });
    io::write_atomically(path("pipe"), "through");
    reader.join();
    EXPECT_EQ(got, "through");
    EXPECT_TRUE(fs::is_fifo(path("pipe")));
}

TEST_F(Files, RefusesWhatIsNoTerrain) {
    refusal("missing.tif");
    write("empty.tif", "");
    refusal("empty.tif");
    write("text.tif", "this is no picture");
    write("text.exr", "this is no picture");
    write("text.png", "this is no picture");
    write("text.hgt", "this is no picture");
    write("text.asc", "this is no picture");
    write("text.xyz", "this is no picture");
    for (const char* name : {"text.tif", "text.exr", "text.png", "text.hgt", "text.asc", "text.xyz"})
        refusal(name);
    write("odd.r16", std::string(998, 'x'));
    EXPECT_NE(refusal("odd.r16").find("--raw"), std::string::npos);
    write("row.asc", "ncols 40\nnrows 1\nxllcorner 0\nyllcorner 0\ncellsize 10\n" + std::string(40 * 2, ' ') +
                         "1 1 1\n");
    EXPECT_NE(refusal("row.asc").find("40 x 1"), std::string::npos);
    write("huge.asc", "ncols 1000000\nnrows 1000000\nxllcorner 0\nyllcorner 0\ncellsize 10\n1 2 3\n");
    EXPECT_NE(refusal("huge.asc").find("2 to 8192"), std::string::npos);
    fs::create_directories(path("folder.tif"));
    EXPECT_NE(refusal("folder.tif").find("folder"), std::string::npos);
}

TEST_F(Files, RefusesValuesThatAreNotFinite) {
    for (const float bad : {NAN, HUGE_VALF, -HUGE_VALF}) {
        io::Heightmap heightmap = rough(16, 16);
        heightmap.heights[17] = bad;
        for (const char* name : {"bad.tif", "bad.exr", "bad.r32"}) {
            io::write_heightmap(path(name), heightmap, std::nullopt);
            EXPECT_NE(refusal(name).find("not finite"), std::string::npos) << name;
        }
        io::Document document;
        document.state = bedrock_terrain({8, 8, 1, 1}, std::vector<float>(64, 1.0F));
        document.state.regolith[3].y = bad;
        io::save_document(path("doc.exr"), document);
        EXPECT_NE(refusal("doc.exr").find("not finite"), std::string::npos);
    }
}

TEST_F(Files, RefusesTruncatedFilesOfEveryKind) {
    const io::Heightmap heightmap = rough(120, 90);
    io::Document document;
    document.state = bedrock_terrain(heightmap.grid, heightmap.heights);
    io::save_document(path("doc.exr"), document);
    for (const char* name : {"a.tif", "a.exr", "a.png", "a.r16", "a.r32"})
        io::write_heightmap(path(name), heightmap, std::nullopt);
    for (const std::string name : {"a.tif", "a.exr", "a.png", "a.r16", "a.r32", "doc.exr"}) {
        const std::string whole = io::read_text(path(name));
        for (const double share : {0.02, 0.3, 0.6, 0.95}) {
            write(name, whole.substr(0, static_cast<std::size_t>(share * static_cast<double>(whole.size()))));
            refusal(name);
        }
    }
}

TEST_F(Files, NeverCrashesOnDamagedBytes) {
    const io::Heightmap heightmap = rough(40, 30);
    for (const char* name : {"a.tif", "a.exr", "a.png"})
        io::write_heightmap(path(name), heightmap, std::nullopt);
    std::mt19937 random(99);
    for (const std::string name : {"a.tif", "a.exr", "a.png"}) {
        const std::string whole = io::read_text(path(name));
        for (int i = 0; i < 150; ++i) {
            std::string damaged = whole;
            for (int k = 0; k < 1 + i % 8; ++k)
                damaged[random() % std::min<std::size_t>(damaged.size(), 600)] = static_cast<char>(random());
            write(name, damaged);
            try {
                io::open_document(path(name), {});
            } catch (const Error& error) {
                EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
            }
        }
    }
}

TEST_F(Files, RefusesBombs) {
    // A PNG header that claims 40000 x 40000 16-bit samples, and one within limits that its bytes cannot
    // hold.
    const auto png = [](unsigned side) {
        std::string header = "\x89PNG\r\n\x1a\n";
        header += std::string("\0\0\0\rIHDR", 8);
        for (int i = 0; i < 2; ++i)
            for (int shift = 24; shift >= 0; shift -= 8)
                header += static_cast<char>(side >> static_cast<unsigned>(shift) & 0xffU);
        header += std::string("\x10\0\0\0\0", 5);
        unsigned crc = ~0U;
        for (std::size_t i = 12; i < header.size(); ++i) {
            crc ^= static_cast<unsigned char>(header[i]);
            for (int k = 0; k < 8; ++k) crc = (crc >> 1U) ^ (0xedb88320U & (0U - (crc & 1U)));
        }
        crc = ~crc;
        for (int shift = 24; shift >= 0; shift -= 8)
            header += static_cast<char>(crc >> static_cast<unsigned>(shift) & 0xffU);
        return header + std::string("\0\0\0\0IDAT", 8) + std::string(300, 'x');
    };
    write("bomb.png", png(40000));
    refusal("bomb.png");
    write("claim.png", png(8192));
    refusal("claim.png");

    // An EXR whose windows claim more than the limits, and more than its few rows hold.
    io::write_heightmap(path("small.exr"), rough(16, 16), std::nullopt);
    const std::string small = io::read_text(path("small.exr"));
    for (const std::int32_t last : {29999, 8191, -5}) {
        std::string claims = small;
        for (const std::string& window :
             {std::string("dataWindow\0box2i\0", 17), std::string("displayWindow\0box2i\0", 20)}) {
            const auto at = claims.find(window);
            ASSERT_NE(at, std::string::npos);
            // Size of the value, then xMin, yMin, xMax, yMax, little endian.
            for (std::size_t corner : {2U, 3U})
                std::memcpy(&claims[at + window.size() + 4 + 4 * corner], &last, sizeof(last));
        }
        write("bomb.exr", claims);
        refusal("bomb.exr");
    }
}

// A PNG of two colours, one bit a pixel, packs 3 MiB of colours into 225 bytes: an evenly coloured 1024 x
// 1024.
TEST_F(Files, ReadsPicturesOfFewColours) {
    const std::string hex =
        "89504e470d0a1a0a0000000d494844520000040000000400010300000045d3b9c000000006504c54"
        "45285ac8ffffff8f7c0905000000964944415478daedc101010000008220ffaf6e48400100000000"
        "00000000000000000000000000000000000000000000000000000000000000000000000000000000"
        "00000000000000000000000000000000000000000000000000000000000000000000000000000000"
        "00000000000000000000000000000000000000000000000000000000000000000000000000000000"
        "000000ef06041e00010dde38640000000049454e44ae426082";
    std::string bytes;
    for (std::size_t i = 0; i < hex.size(); i += 2)
        bytes += static_cast<char>(std::stoi(hex.substr(i, 2), nullptr, 16));
    write("two_colours.png", bytes);
    const io::ColourImage image = io::read_colour_image(path("two_colours.png"));
    EXPECT_EQ(glm::ivec2(image.width, image.height), glm::ivec2(1024));
    ASSERT_EQ(image.rgba.size(), std::size_t{4} << 20U);
    EXPECT_EQ(std::vector<int>(image.rgba.begin(), image.rgba.begin() + 3), (std::vector<int>{40, 90, 200}));
}

TEST_F(Files, AFailedWriteLeavesTheOldFile) {
    write("old.tif", "precious");
    fs::create_directories(path("readonly"));
    EXPECT_THROW(io::write_atomically(path("no/such/folder/a.tif"), "x"), Error);
    EXPECT_THROW(io::write_atomically(path("readonly"), "x"), Error);
    io::write_atomically(path("old.tif"), "newer");
    EXPECT_EQ(io::read_text(path("old.tif")), "newer");
    // Nothing but the files themselves is left behind.
    int entries = 0;
    for (const auto& entry : fs::directory_iterator(path(".")))
        entries += entry.path().filename() != "readonly" ? 1 : 0;
    EXPECT_EQ(entries, 1);
}

TEST_F(Files, RealFilesAreReadAsTheirSourcesSay) {
    const char* data = std::getenv("TALUS_DATA");
    if (!data) {
        std::puts("TALUS_DATA is not set: real files were not read");
        return;
    }
    const io::Heightmap hills = io::read_heightmap(fs::path(data) / "bigtujunga_30m_1197x643.tif", {});
    EXPECT_EQ(hills.grid.nx, 1197);
    EXPECT_EQ(hills.grid.ny, 643);
    EXPECT_NEAR(hills.grid.dx, 30, 1e-9);
    const auto [low, high] = std::minmax_element(hills.heights.begin(), hills.heights.end());
    EXPECT_EQ(*low, 315);
    EXPECT_EQ(*high, 2295);
    EXPECT_NE(hills.georeference->wkt.find("32611"), std::string::npos);
    const io::Heightmap tatras = io::read_heightmap(fs::path(data) / "N49E020.hgt", {});
    EXPECT_EQ(tatras.grid.nx, 1201);
    EXPECT_NEAR(tatras.grid.dx, 60.3, 0.5);
    EXPECT_NEAR(tatras.grid.dy, 92.6, 0.3);
    EXPECT_GE(*std::min_element(tatras.heights.begin(), tatras.heights.end()), 150);
    EXPECT_NE(tatras.notes[0].find("29 void samples"), std::string::npos) << tatras.notes[0];
    // GeoTIFF keeps where it lies.
    io::write_heightmap(path("copy.tif"), hills, std::nullopt);
    EXPECT_EQ(io::read_heightmap(path("copy.tif"), {}).georeference->transform,
              hills.georeference->transform);
}

}  // namespace
}  // namespace talus::io_test
