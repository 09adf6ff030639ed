// Photos: colours and where they lie, of any raster, and what cannot be one.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <random>

#include "sim/error.h"
#include "sim/io/image_file.h"
#include "sim/io/photo_file.h"
#include "sim/io/photo_writer.h"
#include "sim/tiled/screen_colour.h"
#include "tests/scenes/broken_file.h"
#include "tests/scenes/file_size_limit.h"
#include "tests/scenes/memory_tiles.h"
#include "tests/scenes/refusal.h"

namespace talus::photo_file_test {
namespace {

namespace fs = std::filesystem;

// 100 m a sample from (500000, 3800000), the north-west corner.
const Georeference utm{"", {500000, 100, 0, 3800000, 0, -100}};

class PhotoFiles : public ::testing::Test {
  protected:
    void SetUp() override { fs::create_directories(folder_); }
    void TearDown() override { fs::remove_all(folder_); }
    fs::path path(const std::string& name) const { return folder_ / name; }

    // Colours at random.
    std::vector<std::uint8_t> write_picture(const std::string& name, glm::ivec2 size) const {
        std::mt19937 random(7);
        std::vector<std::uint8_t> rgb(3 * static_cast<std::size_t>(size.x) * size.y);
        for (std::uint8_t& one : rgb) one = static_cast<std::uint8_t>(random() % 256);
        io::write_rgb(path(name), size.x, size.y, rgb);
        return rgb;
    }
    static std::string band(int number, const std::string& picture, int from_band, const std::string& more,
                            const std::string& type = "Byte") {
        return "<VRTRasterBand dataType=\"" + type + "\" band=\"" + std::to_string(number) + "\">" + more +
               "<ComplexSource><SourceFilename relativeToVRT=\"1\">" + picture +
               "</SourceFilename><SourceBand>" + std::to_string(from_band) + "</SourceBand>" +
               (type == "UInt16" ? "<ScaleRatio>257</ScaleRatio>" : "") + "</ComplexSource></VRTRasterBand>";
    }
    // A raster made of others, of these elements.
    void write_raster(const std::string& name, glm::ivec2 size, const std::string& elements) const {
        std::ofstream(path(name)) << "<VRTDataset rasterXSize=\"" << size.x << "\" rasterYSize=\"" << size.y
                                  << "\">" << elements << "</VRTDataset>";
    }
    static std::string lies(const std::string& transform, const std::string& system = "") {
        return (system.empty() ? "" : "<SRS>" + system + "</SRS>") + "<GeoTransform>" + transform +
               "</GeoTransform>";
    }
    static std::string colours(const std::string& picture) {
        return band(1, picture, 1, "<ColorInterp>Red</ColorInterp>") +
               band(2, picture, 2, "<ColorInterp>Green</ColorInterp>") +
               band(3, picture, 3, "<ColorInterp>Blue</ColorInterp>");
    }
    std::vector<PhotoTexel> texels(const io::PhotoFile& photo, int level, const TileSamples& samples) const {
        std::vector<PhotoTexel> read;
        photo.make_reader()(level, samples, read);
        return read;
    }
    std::string refusal(const std::string& name, const std::optional<Georeference>& ground = {}) const {
        return refusal_of(name, [&] {
            const io::PhotoFile photo(path(name), ground);
            photo.place_over({11, 11, 100, 100}, ground);
            texels(photo, 0, {glm::ivec2(0), glm::ivec2(1)});
        });
    }

  private:
    fs::path folder_ = fs::temp_directory_path() / ("talus_photos_" + std::to_string(::getpid()));
};

TEST_F(PhotoFiles, AreReadAtAllLevelsAndWrittenAsTheyAre) {
    const glm::ivec2 size(1300, 601);
    const std::vector<std::uint8_t> rgb = write_picture("a.png", size);
    ASSERT_TRUE(io::write_photo(path("a.png"), path("a.tif"), [](double) { return true; }));
    const io::PhotoFile plain(path("a.png"), {});
    const io::PhotoFile tiled(path("a.tif"), {});
    for (const io::PhotoFile* photo : {&plain, &tiled}) {
        EXPECT_EQ(photo->texels(), size);
        EXPECT_FALSE(photo->is_placed());
        const std::vector<PhotoTexel> all = texels(*photo, 0, {glm::ivec2(0), size});
        for (std::size_t i = 0; i < all.size(); ++i)
            ASSERT_EQ(all[i], (PhotoTexel{rgb[3 * i], rgb[3 * i + 1], rgb[3 * i + 2], 255})) << i;
        // Beside the photo its edge goes on.
        const std::vector<PhotoTexel> corner = texels(*photo, 0, {glm::ivec2(-2), glm::ivec2(3)});
        for (const PhotoTexel& one : corner) EXPECT_EQ(one, all.front());
        // A level's texel has about the colour of the mean light of those that it stands for: squares of
        // colours are near the light.
        constexpr int off = 9;
        const auto colour_of_mean = [&](glm::ivec2 from, glm::ivec2 count) {
            float light = 0;
            for (int y = 0; y < count.y; ++y)
                for (int x = 0; x < count.x; ++x)
                    light += from_screen(all[static_cast<std::size_t>(from.y + y) * size.x + from.x + x].g);
            return static_cast<int>(to_screen(light / static_cast<float>(count.x * count.y)));
        };
        const std::vector<PhotoTexel> half = texels(*photo, 1, {{10, 0}, {8, 4}});
        for (int y = 0; y < 4; ++y)
            for (int x = 0; x < 8; ++x)
                EXPECT_NEAR(half[static_cast<std::size_t>(y) * 8 + x].g,
                            colour_of_mean({20 + 2 * x, 2 * y}, {2, 2}), off)
                    << x << ' ' << y;
        const std::vector<PhotoTexel> whole = texels(*photo, 11, {glm::ivec2(0), glm::ivec2(1)});
        EXPECT_NEAR(whole.front().g, colour_of_mean({0, 0}, size), off);
    }
}

TEST_F(PhotoFiles, LieWhereTheySay) {
    write_picture("a.png", {40, 30});
    write_raster("a.vrt", {40, 30}, lies("499950, 25, 0, 3800025, 0, -25") + colours("a.png"));
    const io::PhotoFile photo(path("a.vrt"), utm);
    ASSERT_TRUE(photo.is_placed());
    const PhotoPlace place = photo.place_over({11, 11, 100, 100}, utm);
    // The ground's first sample is at (500050, 3799950): 100 m east of the photo's corner, 75 m south.
    EXPECT_NEAR(place.first.x, 100 / 25.0 - 0.5, 1e-9);
    EXPECT_NEAR(place.first.y, 75 / 25.0 - 0.5, 1e-9);
    EXPECT_NEAR(place.scale.x, 4, 1e-12);
    EXPECT_NEAR(place.scale.y, 4, 1e-12);
    // Without a place on Earth its edges lie on the ground's outer samples.
    const PhotoPlace stretched = io::PhotoFile(path("a.vrt"), {}).place_over({11, 21, 1, 1}, {});
    EXPECT_NEAR(stretched.first.x + 10 * stretched.scale.x, 39.5, 1e-9);
    EXPECT_NEAR(stretched.first.y + 20 * stretched.scale.y, 29.5, 1e-9);
    EXPECT_NEAR(stretched.first.x, -0.5, 1e-12);
}

TEST_F(PhotoFiles, AreTurnedNorthUp) {
    const glm::ivec2 size(40, 30);
    const std::vector<std::uint8_t> rgb = write_picture("a.png", size);
    write_raster("south.vrt", size, lies("500000, 100, 0, 3797000, 0, 100") + colours("a.png"));
    const io::PhotoFile photo(path("south.vrt"), utm);
    const PhotoPlace place = photo.place_over({40, 30, 100, 100}, utm);
    EXPECT_NEAR(place.first.x, 0, 1e-6);
    EXPECT_NEAR(place.first.y, 0, 1e-6);
    const std::vector<PhotoTexel> all = texels(photo, 0, {glm::ivec2(0), photo.texels()});
    for (const glm::ivec2 at : {glm::ivec2(3, 4), glm::ivec2(20, 20), glm::ivec2(37, 2)}) {
        const std::size_t north_first = static_cast<std::size_t>(at.y) * size.x + at.x;
        const std::size_t south_first = static_cast<std::size_t>(size.y - 1 - at.y) * size.x + at.x;
        EXPECT_NEAR(all[north_first].r, rgb[3 * south_first], 1) << at.x;
    }
}

// A degree east of the zone's meridian, at 34 degrees north, lies at 592350 m east and 3762607 m north
// (Snyder 1987, equations 8-9 and 8-10).
TEST_F(PhotoFiles, AreBroughtIntoTheGroundsSystem) {
    std::vector<std::uint8_t> rgb(std::size_t{3} * 200 * 200, 0);
    const auto paint = [&](int x, int y) {
        for (int dy = -2; dy < 2; ++dy)
            for (int dx = -2; dx < 2; ++dx) rgb[3 * (static_cast<std::size_t>(y + dy) * 200 + x + dx)] = 255;
    };
    paint(100, 100);
    io::write_rgb(path("a.png"), 200, 200, rgb);
    write_raster("degrees.vrt", {200, 200},
                 lies("-116.1, 0.001, 0, 34.1, 0, -0.001", "EPSG:4326") + colours("a.png"));
    const Georeference ground{
        "PROJCS[\"UTM 11N\",GEOGCS[\"WGS 84\",DATUM[\"WGS_1984\",SPHEROID[\"WGS "
        "84\",6378137,298.257223563]],PRIMEM[\"Greenwich\",0],UNIT[\"degree\",0.0174532925199433]],"
        "PROJECTION[\"Transverse_Mercator\"],PARAMETER[\"latitude_of_origin\",0],PARAMETER["
        "\"central_meridian\",-117],PARAMETER[\"scale_factor\",0.9996],PARAMETER[\"false_easting\","
        "500000],PARAMETER[\"false_northing\",0],UNIT[\"metre\",1]]",
        {590000, 100, 0, 3765000, 0, -100}};
    const io::PhotoFile photo(path("degrees.vrt"), ground);
    const PhotoPlace place = photo.place_over({51, 51, 100, 100}, ground);
    const std::vector<PhotoTexel> all = texels(photo, 0, {glm::ivec2(0), photo.texels()});
    glm::dvec2 middle(0);
    double sum = 0;
    for (int y = 0; y < photo.texels().y; ++y)
        for (int x = 0; x < photo.texels().x; ++x) {
            const double red = all[static_cast<std::size_t>(y) * photo.texels().x + x].r;
            middle += red * glm::dvec2(x, y);
            sum += red;
        }
    ASSERT_GT(sum, 255);
    // The ground's column and row, and from them its coordinates.
    const glm::dvec2 at = (middle / sum - place.first) / place.scale;
    EXPECT_NEAR(590000 + (at.x + 0.5) * 100, 592350, 20);
    EXPECT_NEAR(3765000 - (at.y + 0.5) * 100, 3762607, 20);
    // What was brought in has no colours beside it.
    EXPECT_EQ(all.front().a, 0);
}

TEST_F(PhotoFiles, CoverWhatTheirAlphaAndNodataSay) {
    const glm::ivec2 size(16, 8);
    const std::vector<std::uint8_t> rgb = write_picture("a.png", size);
    std::vector<std::uint8_t> alpha(std::size_t{3} * 16 * 8, 255);
    alpha[0] = 0;
    alpha[3] = 128;
    io::write_rgb(path("alpha.png"), 16, 8, alpha);
    write_raster("a.vrt", size,
                 colours("a.png") + band(4, "alpha.png", 1, "<ColorInterp>Alpha</ColorInterp>"));
    const std::vector<PhotoTexel> read = texels(io::PhotoFile(path("a.vrt"), {}), 0, {glm::ivec2(0), size});
    EXPECT_EQ(read[0], (PhotoTexel{0, 0, 0, 0}));
    EXPECT_EQ(read[1].a, 128);
    EXPECT_NEAR(from_screen(read[1].r), from_screen(rgb[3]) * 128 / 255, 0.005);
    EXPECT_EQ(read[2], (PhotoTexel{rgb[6], rgb[7], rgb[8], 255}));
    // It stays so in the written file.
    ASSERT_TRUE(io::write_photo(path("a.vrt"), path("a.tif"), [](double) { return true; }));
    EXPECT_EQ(texels(io::PhotoFile(path("a.tif"), {}), 0, {glm::ivec2(0), size}), read);
    const std::string nodata = "<NoDataValue>" + std::to_string(rgb[6]) + "</NoDataValue>";
    write_raster("grey.vrt", size, band(1, "a.png", 1, nodata));
    const std::vector<PhotoTexel> grey =
        texels(io::PhotoFile(path("grey.vrt"), {}), 0, {glm::ivec2(0), size});
    EXPECT_EQ(grey[2].a, 0);
    EXPECT_EQ(grey[1].a, rgb[3] == rgb[6] ? 0 : 255);
}

TEST_F(PhotoFiles, HaveBandsOfSixteenBitsOneBandOrATable) {
    const glm::ivec2 size(16, 8);
    const std::vector<std::uint8_t> rgb = write_picture("a.png", size);
    const auto read = [&](const std::string& name) {
        return texels(io::PhotoFile(path(name), {}), 0, {glm::ivec2(0), size});
    };
    write_raster("wide.vrt", size,
                 band(1, "a.png", 1, "", "UInt16") + band(2, "a.png", 2, "", "UInt16") +
                     band(3, "a.png", 3, "", "UInt16"));
    EXPECT_EQ(read("wide.vrt")[5], (PhotoTexel{rgb[15], rgb[16], rgb[17], 255}));
    write_raster("grey.vrt", size, band(1, "a.png", 2, ""));
    EXPECT_EQ(read("grey.vrt")[5], (PhotoTexel{rgb[16], rgb[16], rgb[16], 255}));
    std::string table = "<ColorInterp>Palette</ColorInterp><ColorTable>";
    for (int i = 0; i < 256; ++i)
        table += "<Entry c1=\"" + std::to_string(255 - i) + "\" c2=\"7\" c3=\"" + std::to_string(i / 2) +
                 "\" c4=\"255\"/>";
    write_raster("table.vrt", size, band(1, "a.png", 1, table + "</ColorTable>"));
    const PhotoTexel of_table{static_cast<std::uint8_t>(255 - rgb[15]), 7,
                              static_cast<std::uint8_t>(rgb[15] / 2), 255};
    EXPECT_EQ(read("table.vrt")[5], of_table);
    ASSERT_TRUE(io::write_photo(path("table.vrt"), path("table.tif"), [](double) { return true; }));
    EXPECT_EQ(read("table.tif")[5], of_table);
}

// What is left out is left out by all bands; alpha counts behind other bands too; colours go by their names.
TEST_F(PhotoFiles, ChooseTheirBandsByWhatTheyMean) {
    const glm::ivec2 size(16, 8);
    const std::vector<std::uint8_t> rgb = write_picture("a.png", size);
    std::vector<std::uint8_t> alpha(std::size_t{3} * 16 * 8, 255);
    alpha[0] = 0;
    alpha[3] = 128;
    io::write_rgb(path("alpha.png"), 16, 8, alpha);
    const auto read = [&](const std::string& name) {
        return texels(io::PhotoFile(path(name), {}), 0, {glm::ivec2(0), size});
    };
    const auto nodata = [](int value) { return "<NoDataValue>" + std::to_string(value) + "</NoDataValue>"; };
    // The third texel has the red that is nodata, and neither its green nor its blue.
    write_raster("nodata.vrt", size,
                 band(1, "a.png", 1, nodata(rgb[6])) + band(2, "a.png", 2, nodata(rgb[7] ^ 1)) +
                     band(3, "a.png", 3, nodata(rgb[8] ^ 1)));
    EXPECT_EQ(read("nodata.vrt")[2], (PhotoTexel{rgb[6], rgb[7], rgb[8], 255}));
    write_raster("void.vrt", size,
                 band(1, "a.png", 1, nodata(rgb[6])) + band(2, "a.png", 2, nodata(rgb[7])) +
                     band(3, "a.png", 3, nodata(rgb[8])));
    EXPECT_EQ(read("void.vrt")[2].a, 0);
    write_raster("infrared.vrt", size,
                 colours("a.png") + band(4, "a.png", 1, "") +
                     band(5, "alpha.png", 1, "<ColorInterp>Alpha</ColorInterp>"));
    EXPECT_EQ(read("infrared.vrt")[0].a, 0);
    EXPECT_EQ(read("infrared.vrt")[1].a, 128);
    EXPECT_EQ(read("infrared.vrt")[5], (PhotoTexel{rgb[15], rgb[16], rgb[17], 255}));
    write_raster("turned.vrt", size,
                 band(1, "a.png", 3, "<ColorInterp>Blue</ColorInterp>") +
                     band(2, "a.png", 2, "<ColorInterp>Green</ColorInterp>") +
                     band(3, "a.png", 1, "<ColorInterp>Red</ColorInterp>"));
    EXPECT_EQ(read("turned.vrt")[5], (PhotoTexel{rgb[15], rgb[16], rgb[17], 255}));
    write_raster("wide.vrt", size,
                 band(1, "a.png", 1, "", "UInt16") + band(2, "a.png", 2, "", "UInt16") +
                     band(3, "a.png", 3, "", "UInt16") +
                     band(4, "alpha.png", 1, "<ColorInterp>Alpha</ColorInterp>", "UInt16"));
    EXPECT_EQ(read("wide.vrt")[1].a, 128);
}

TEST_F(PhotoFiles, AreNotAnotherOneOnTheWay) {
    write_picture("a.png", {700, 600});
    write_picture("b.png", {300, 200});
    ASSERT_TRUE(io::write_photo(path("a.png"), path("a.tif"), [](double) { return true; }));
    const io::PhotoFile photo(path("a.tif"), {});
    auto reader = photo.make_reader();
    std::vector<PhotoTexel> read;
    scenes::BrokenFile broken(path("a.tif"));
    EXPECT_THROW(reader(1, {glm::ivec2(0), glm::ivec2(50)}, read), Error);
    ASSERT_TRUE(io::write_photo(path("b.png"), path("a.tif"), [](double) { return true; }));
    for (const int level : {0, 9})
        EXPECT_THROW(reader(level, {glm::ivec2(0), glm::ivec2(1)}, read), Error) << level;
}

TEST(ScreenColours, AreThoseOfTheirLight) {
    for (int colour = 0; colour < 256; ++colour)
        EXPECT_EQ(to_screen(from_screen(static_cast<std::uint8_t>(colour))), colour);
    EXPECT_EQ(from_screen(255), 1);
    EXPECT_NEAR(from_screen(188), 0.5, 0.005);  // half of the light, by the standard's table
    EXPECT_EQ(to_screen(-1), 0);
    EXPECT_EQ(to_screen(2), 255);
}

TEST(HeightsBetween, HoldAllThatLiesThere) {
    const Grid grid{700, 500, 10, 10};
    std::vector<float> heights(grid.count());
    for (std::size_t i = 0; i < heights.size(); ++i)
        heights[i] = static_cast<float>(300 * std::sin(1e-4 * static_cast<double>(i)) + (i * 7919) % 100);
    const scenes::MemoryTiles tiles(grid, heights, 32);
    const HeightsBetween whole = heights_between(grid, heights);
    const HeightsBetween tiled = heights_between(tiles.tree(), tiles.bounds());
    std::mt19937 random(3);
    std::uniform_real_distribution<double> x(-50, 750);
    std::uniform_real_distribution<double> y(-50, 550);
    for (int i = 0; i < 300; ++i) {
        const glm::dvec2 a(x(random), y(random));
        const glm::dvec2 b(x(random), y(random));
        const glm::dvec2 first = glm::min(a, b);
        const glm::dvec2 last = glm::max(a, b);
        std::optional<glm::vec2> range;
        for (int row = 0; row < grid.ny; ++row)
            for (int column = 0; column < grid.nx; ++column) {
                if (column < first.x || column > last.x || row < first.y || row > last.y) continue;
                const float h = heights[static_cast<std::size_t>(row) * grid.nx + column];
                range = range ? glm::vec2(std::min(range->x, h), std::max(range->y, h)) : glm::vec2(h);
            }
        if (!range) continue;
        for (const HeightsBetween* told : {&whole, &tiled}) {
            const std::optional<glm::vec2> between = (*told)(first, last);
            ASSERT_TRUE(between);
            EXPECT_LE(between->x, range->x);
            EXPECT_GE(between->y, range->y);
        }
    }
    EXPECT_FALSE(whole({-20, 0}, {-10, 400}));
    EXPECT_FALSE(tiled({0, 501}, {700, 600}));
}

TEST_F(PhotoFiles, RefuseWhatIsNone) {
    write_picture("a.png", {16, 8});
    std::ofstream(path("words.tif")) << "no picture";
    refusal("words.tif");
    refusal("absent.tif");
    write_raster("floats.vrt", {16, 8}, band(1, "a.png", 1, "", "Float32"));
    EXPECT_NE(refusal("floats.vrt").find("Float32"), std::string::npos);
    write_raster("two.vrt", {16, 8}, band(1, "a.png", 1, "") + band(2, "a.png", 2, ""));
    EXPECT_NE(refusal("two.vrt").find("1 or 3"), std::string::npos);
    write_raster("torn.vrt", {16, 8}, colours("gone.png"));
    refusal("torn.vrt");
    write_raster("large.vrt", {9000, 8}, colours("a.png"));
    EXPECT_NE(refusal("large.vrt").find("talus tile --texture"), std::string::npos);
    write_raster("beside.vrt", {16, 8}, lies("600000, 25, 0, 3800000, 0, -25") + colours("a.png"));
    EXPECT_NE(refusal("beside.vrt", utm).find("beside"), std::string::npos);
    const Georeference turned{"", {500000, 100, 30, 3800000, 30, -100}};
    refusal("beside.vrt", turned);
}

// A level that is a single block of the file too.
TEST_F(PhotoFiles, AreReadAgainWhenTheyComeBack) {
    write_picture("a.png", {700, 600});
    ASSERT_TRUE(io::write_photo(path("a.png"), path("a.tif"), [](double) { return true; }));
    const io::PhotoFile photo(path("a.tif"), {});
    auto read = [reader = photo.make_reader()](int level) mutable {
        std::vector<PhotoTexel> texels;
        reader(level, {glm::ivec2(20), glm::ivec2(200)}, texels);
        return texels;
    };
    const std::vector<PhotoTexel> finest = texels(photo, 0, {glm::ivec2(20), glm::ivec2(200)});
    const std::vector<PhotoTexel> half = texels(photo, 1, {glm::ivec2(20), glm::ivec2(200)});
    scenes::BrokenFile broken(path("a.tif"));
    EXPECT_THROW(read(1), Error);
    EXPECT_THROW(read(0), Error);
    EXPECT_THROW(read(1), Error);
    broken.mend();
    EXPECT_EQ(read(1), half);
    EXPECT_EQ(read(0), finest);
}

TEST_F(PhotoFiles, AreWrittenAsAWholeOrNotAtAll) {
    write_picture("a.png", {700, 600});
    std::ofstream(path("there.tif")) << "what was there";
    const auto files = [&] {
        return std::distance(fs::directory_iterator(path("")), fs::directory_iterator());
    };
    for (const double last : {0.0, 0.5, 0.9})
        EXPECT_FALSE(io::write_photo(path("a.png"), path("there.tif"), [&](double share) {
            return share < last;
        })) << last;
    EXPECT_EQ(fs::file_size(path("there.tif")), 14U);
    EXPECT_EQ(files(), 2);
    {
        const FileSizeLimit limit(20000);
        EXPECT_THROW(io::write_photo(path("a.png"), path("there.tif"), [](double) { return true; }), Error);
    }
    EXPECT_EQ(fs::file_size(path("there.tif")), 14U);
    EXPECT_EQ(files(), 2);
    EXPECT_THROW(io::write_photo(path("absent.png"), path("b.tif"), [](double) { return true; }), Error);
    EXPECT_EQ(files(), 2);
}

}  // namespace
}  // namespace talus::photo_file_test
