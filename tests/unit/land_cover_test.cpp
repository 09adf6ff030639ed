// Roughness and infiltration that differ from place to place: painted, from rasters, in water and sediment.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>

#include "app/claims/differing_bits.h"
#include "app/claims/water_scenes.h"
#include "sim/error.h"
#include "sim/gpu/context.h"
#include "sim/io/heightmap.h"
#include "sim/io/raster_values.h"
#include "sim/journal.h"
#include "sim/simulation.h"
#include "sim/terrain/generate.h"
#include "sim/terrain/layers.h"
#include "sim/terrain/reshape.h"
#include "sim/terrain/state_hash.h"
#include "tests/scenes/broken_file.h"
#include "tests/scenes/parameters_with.h"
#include "tests/scenes/refusal.h"
#include "tests/scenes/undo_trail.h"

namespace talus::land_cover_test {
namespace {

namespace fs = std::filesystem;

const Grid grid{70, 66, 5, 4};
constexpr float nothing = std::numeric_limits<float>::quiet_NaN();

TerrainState hills() {
    return bedrock_terrain(grid, generate_heights(grid, {"hills", 3, 20}));
}

TakeRaster raster_of(const std::string& number, std::vector<float> values) {
    return {number, {"/of/a/test.tif", "", 7}, std::make_shared<const std::vector<float>>(std::move(values))};
}

std::uint64_t hash_of(const Simulation& simulation) {
    return state_hash(simulation.read());
}

Dab paint_of(Material material, double value) {
    Dab dab;
    dab.material = material;
    dab.x_m = 150;
    dab.y_m = 120;
    dab.radius_m = 90;
    dab.falloff = 0.5;
    dab.blend = 0.6;
    dab.target_m = value;
    return dab;
}

double farthest(const std::vector<glm::vec4>& one, const std::vector<glm::vec4>& other) {
    double farthest = 0;
    for (std::size_t i = 0; i < one.size(); ++i)
        farthest = std::max<double>(farthest, std::abs(one[i].x - other[i].x));
    return farthest;
}

class LandCoverOfEitherOrder : public testing::TestWithParam<int> {
  protected:
    static Parameters rainy(std::initializer_list<const char*> assignments) {
        Parameters all = parameters_with({"time.tick_s=5", "water.rain=200", "erosion.on=true",
                                          "erosion.acceleration=100", "thermal.on=false"});
        for (const char* assignment : assignments) all.set_assignment(assignment);
        all.set("water.order", GetParam());
        return all;
    }
};
INSTANTIATE_TEST_SUITE_P(LandCover, LandCoverOfEitherOrder, testing::Values(1, 2));

// The same numbers by another way: only roundings differ.
TEST_P(LandCoverOfEitherOrder, OfOneValueIsTheParameter) {
    const gpu::Context context;
    Simulation by_parameter(hills(), rainy({"water.manning=0.06", "water.infiltration=30"}));
    Simulation by_raster(hills(), rainy({"water.manning=0.02", "water.infiltration=5"}));
    by_raster.apply(raster_of("manning", std::vector<float>(grid.count(), 0.06F)));
    by_raster.apply(raster_of("infiltration", std::vector<float>(grid.count(), 30)));
    Simulation neither(hills(), rainy({"water.manning=0.02", "water.infiltration=5"}));
    for (Simulation* one : {&by_parameter, &by_raster, &neither}) one->apply(Ticks{60});
    const TerrainState wanted = by_parameter.read();
    const TerrainState found = by_raster.read();
    const double apart = farthest(wanted.water, found.water);
    const double otherwise = farthest(wanted.water, neither.read().water);
    fmt::print("order {}: {:.1e} m apart, {:.1e} m without the rasters\n", GetParam(), apart, otherwise);
    EXPECT_LT(apart, 1e-3 * otherwise);
    EXPECT_NEAR(by_raster.ledger().water_out / by_parameter.ledger().water_out, 1, 1e-5);
}

// A pond loses what the raster says, where that says something, and what the parameters say elsewhere.
TEST_P(LandCoverOfEitherOrder, InfiltrationTakesWhatItSays) {
    const gpu::Context context;
    Parameters all = parameters_with({"time.tick_s=5", "water.infiltration=36", "water.evaporation=18",
                                      "water.boundary.north=wall", "water.boundary.south=wall",
                                      "water.boundary.west=wall", "water.boundary.east=wall"});
    all.set("water.order", GetParam());
    TerrainState pond = bedrock_terrain(grid, std::vector<float>(grid.count(), 0));
    pond.water.assign(grid.count(), glm::vec4(4, 0, 0, 0));
    Simulation simulation(pond, all);
    std::vector<float> values(grid.count(), nothing);
    double rates_mm_per_h = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (i % 3 == 0) values[i] = static_cast<float>(i % 500);
        rates_mm_per_h += 18 + (i % 3 == 0 ? static_cast<double>(i % 500) : 36.0);
    }
    simulation.apply(raster_of("infiltration", values));
    simulation.apply(Ticks{100});
    const double wanted_m3 = rates_mm_per_h * 1e-3 / 3600 * 500 * grid.dx * grid.dy;
    EXPECT_NEAR(simulation.ledger().water_out / wanted_m3, 1, 1e-6);
    EXPECT_NEAR((simulation.ledger().water_initial - simulation.ledger().water_final) / wanted_m3, 1, 1e-5);
}

// What is undone, or wiped off, leaves no trace in what runs after it.
TEST_P(LandCoverOfEitherOrder, UndoneLeavesNoTrace) {
    const gpu::Context context;
    const Parameters all = rainy({"water.manning=0.03", "water.infiltration=10", "water.boundary.west=inflow",
                                  "water.inflow=20", "water.inflow_over=conveyance"});
    Simulation plain(hills(), all);
    Simulation undone(hills(), all, 256U << 20U);
    Simulation wiped(hills(), all);
    // By many strokes that do not take it off at once.
    const auto wipe_off = [&](Dab wipe) {
        wipe.effect = LowerDab{};
        wipe.blend = 0.6;
        for (int i = 0; i < 20; ++i) wiped.apply(everywhere(grid, wipe));
    };
    for (Simulation* one : {&plain, &undone, &wiped}) one->apply(Ticks{3});
    undone.end_entry();
    for (const Material material : {Material::manning, Material::infiltration}) {
        undone.apply(paint_of(material, 0.2));
        wiped.apply(paint_of(material, 0.2));
        wipe_off(paint_of(material, 0));
    }
    const std::uint64_t before = hash_of(undone);
    undone.undo();
    undone.undo();
    EXPECT_NE(hash_of(undone), before);
    EXPECT_EQ(hash_of(undone), hash_of(plain));
    for (Simulation* one : {&plain, &undone, &wiped}) one->apply(Ticks{10});
    EXPECT_EQ(hash_of(undone), hash_of(plain));
    EXPECT_EQ(hash_of(wiped), hash_of(plain));
    // And what is made of it anew goes on the same way.
    Simulation reopened(wiped.read(), wiped.parameters());
    for (Simulation* one : {&plain, &reopened}) one->apply(Ticks{5});
    EXPECT_EQ(hash_of(reopened), hash_of(plain));
}

TEST_P(LandCoverOfEitherOrder, UndoLeadsBackAndForth) {
    const gpu::Context context;
    Simulation simulation(hills(), rainy({}), 256U << 20U);
    std::vector<float> values(grid.count(), nothing);
    for (std::size_t i = 0; i < values.size(); i += 2) values[i] = 0.001F * static_cast<float>(i % 100);
    const auto act = [&](int number) {
        if (number == 0) simulation.apply(Ticks{4});
        if (number == 1) simulation.apply(raster_of("manning", values));
        if (number == 2) simulation.apply(paint_of(Material::infiltration, 60));
        if (number == 3) simulation.apply(Ticks{4});
        if (number == 4) simulation.apply(Crop{{20, 20, 200, 200}});
        if (number == 5) simulation.apply(Turn{1});
        if (number == 6) simulation.apply(Ticks{4});
        simulation.end_entry();
    };
    expect_undo_leads_back_and_forth(simulation, 7, act, [](const LedgerReading& a, const LedgerReading& b) {
        EXPECT_EQ(a.water_out, b.water_out);
    });
}

// Water that seeps away wakes its tile, and no other.
TEST_P(LandCoverOfEitherOrder, SkippingChangesNoBit) {
    const gpu::Context context;
    scenes::WaterScene scene = scenes::basin(320, 5);
    scene.settings.order = GetParam();
    scene.settings.manning_s_per_m13 = 0.02;
    scene.settings.manning_painted = scene.settings.infiltration_painted = true;
    // A pool at rest in one corner, of which a part seeps away, and one that moves in another.
    scene.water = [bed = scene.bed](double x, double y, double) {
        const bool moves = x > 1200 && y > 1200 && x < 1400;
        return glm::dvec3(x < 500 && y < 500 ? std::max(0.0, 2 - bed(x, y)) : moves ? 3 : 0, 0, 0);
    };
    TerrainState start = scene.state();
    start.land_cover.assign(start.grid.count(), glm::vec4(0));
    for (int row = 0; row < 320; ++row)
        for (int column = 0; column < 320; ++column) {
            glm::vec4& cover = start.land_cover[static_cast<std::size_t>(row) * 320 + column];
            if (column % 90 < 40) cover = {0.02, 0.4, 0, 0};
            if (row > 250 && column < 30) cover.z = 100, cover.w = 1;
        }
    scenes::WaterRun sparse(start, scene.settings);
    scenes::WaterRun dense(start, scene.settings);
    dense.settings.skips_rest = false;
    sparse.run(1, 60);
    dense.run(1, 60);
    EXPECT_EQ(claims::differing_bits(sparse.read().water, dense.read().water), 0U);
    EXPECT_LT(sparse.water.work().tiles, dense.water.work().tiles * 9 / 10);
}

// Roughness goes from what the parameter says to what is painted, never below both, as far as the dab's
// weight.
TEST(LandCover, PaintLiesBetweenTheParameterAndTheBrush) {
    const gpu::Context context;
    Simulation simulation(hills(), parameters_with({"water.manning=0.03"}));
    simulation.apply(paint_of(Material::manning, 0.1));
    simulation.apply(paint_of(Material::manning, 0.06));
    const TerrainState state = simulation.read();
    ASSERT_FALSE(state.land_cover.empty());
    double most = 0;
    for (const glm::vec4& cover : state.land_cover) {
        const double n = cover.x + (1 - cover.y) * 0.03;
        EXPECT_GE(n, 0.03 - 1e-7);
        most = std::max(most, n);
        EXPECT_EQ(cover.z, 0);
        EXPECT_EQ(cover.w, 0);
    }
    // 0.03, then 0.6 of the way to 0.1, then 0.6 of the way to 0.06; what comes within a thousandth is there.
    EXPECT_NEAR(most, 0.072 + 0.6 * (0.06 - 0.072), 1e-3 * 0.06);
}

TEST(LandCover, ParametersGoOnWhereNothingIsPainted) {
    const gpu::Context context;
    Simulation painted(hills(), parameters_with({"time.tick_s=5", "water.rain=300", "water.manning=0.02"}));
    painted.apply(paint_of(Material::manning, 0.3));
    painted.apply(SetParameter{"water.manning", 0.09});
    painted.apply(Ticks{40});
    // The same as a raster of both values.
    Simulation whole(hills(), parameters_with({"time.tick_s=5", "water.rain=300", "water.manning=0.5"}));
    std::vector<float> values;
    for (const glm::vec4& cover : painted.read().land_cover)
        values.push_back(static_cast<float>(cover.x + (1 - cover.y) * 0.09));
    whole.apply(raster_of("manning", values));
    whole.apply(Ticks{40});
    EXPECT_LT(farthest(painted.read().water, whole.read().water), 1e-5);
}

TEST(LandCover, RefusesWhatNoRasterMayHold) {
    const gpu::Context context;
    Simulation simulation(hills(), parameters_with({}));
    const std::uint64_t before = hash_of(simulation);
    const auto refusal = [&](const TakeRaster& take) -> std::string {
        try {
            simulation.apply(take);
        } catch (const Error& error) {
            return error.what();
        }
        return "";
    };
    EXPECT_EQ(refusal(raster_of("manning", std::vector<float>(grid.count(), 41))),
              "'/of/a/test.tif' holds a manning of 41, it must be 0 to 1");
    EXPECT_NE(refusal(raster_of("rain", std::vector<float>(grid.count(), -1))), "");
    EXPECT_NE(refusal(raster_of("manning", std::vector<float>(3, 0.1F))), "");
    EXPECT_NE(refusal(raster_of("lava", std::vector<float>(grid.count(), 0.1F))).find("infiltration"),
              std::string::npos);
    EXPECT_NE(refusal({"manning", {"/of/a/test.tif", "", 7}, nullptr}), "");
    EXPECT_EQ(hash_of(simulation), before);
    EXPECT_TRUE(simulation.journal().operations().empty());
}

TEST(LandCover, RastersBringWhatBrushesPaintToo) {
    const gpu::Context context;
    Simulation simulation(hills(), parameters_with({"time.tick_s=5"}));
    for (const PaintedNumberDescription& number : painted_numbers()) {
        std::vector<float> values(grid.count(), nothing);
        for (std::size_t i = 0; i < values.size(); i += 2)
            values[i] = static_cast<float>(number.most / 2 + 0.001 * static_cast<double>(i % 7));
        simulation.apply(raster_of(number.name, values));
        const std::vector<float> found = output_of(simulation.read(), number.name);
        for (std::size_t i = 0; i < values.size(); ++i)
            EXPECT_EQ(found[i], std::isnan(values[i]) ? 0 : values[i]) << number.name << " " << i;
    }
    simulation.apply(Ticks{1});
    EXPECT_GT(simulation.ledger().water_in, 0) << "rain by a raster falls";
    const Journal& journal = simulation.journal();
    const JournalFile again = read_journal(write_journal({}, journal), "test.journal");
    EXPECT_EQ(again.operations, journal.operations());
}

// Files.
class RasterFiles : public ::testing::Test {
  protected:
    void SetUp() override { fs::create_directories(folder_); }
    void TearDown() override { fs::remove_all(folder_); }
    fs::path path(const std::string& name) const { return folder_ / name; }

    // The value says the column and the row from the north.
    static float value_at(int column, int row) { return static_cast<float>(column + 100 * row) / 16384; }
    void write_tif(const std::string& name, glm::ivec2 size,
                   const std::optional<Georeference>& place = {}) const {
        io::Heightmap map;
        map.grid = {size.x, size.y, 100, 100};
        map.georeference = place;
        for (int row = 0; row < size.y; ++row)
            for (int column = 0; column < size.x; ++column) map.heights.push_back(value_at(column, row));
        io::write_heightmap(path(name), map, std::nullopt);
    }
    void write_vrt(const std::string& name, glm::ivec2 size, const std::string& elements) const {
        std::ofstream(path(name)) << "<VRTDataset rasterXSize=\"" << size.x << "\" rasterYSize=\"" << size.y
                                  << "\">" << elements << "</VRTDataset>";
    }
    static std::string band_of(const std::string& source, const std::string& more = "", int number = 1) {
        return fmt::format(
            "<VRTRasterBand dataType=\"Float32\" band=\"{}\">{}<ComplexSource><SourceFilename "
            "relativeToVRT=\"1\">{}</SourceFilename><SourceBand>1</SourceBand></ComplexSource></"
            "VRTRasterBand>",
            number, more, source);
    }
    std::string refusal(const std::string& name, const std::optional<Georeference>& ground = {}) const {
        return refusal_of(name, [&] { io::read_raster_values(path(name), {11, 9, 100, 100}, ground); });
    }

  private:
    fs::path folder_ = fs::temp_directory_path() / ("talus_rasters_" + std::to_string(::getpid()));
};

const Georeference at_corner{"", {500000, 100, 0, 3800000, 0, -100}};

TEST_F(RasterFiles, OfTheTerrainsSizeAreTakenSampleBySample) {
    write_tif("a.tif", {11, 9});
    const io::RasterValues read = io::read_raster_values(path("a.tif"), {11, 9, 100, 100}, {});
    ASSERT_EQ(read.values.size(), 99U);
    for (int i = 0; i < 99; ++i)
        EXPECT_EQ(read.values[static_cast<std::size_t>(i)], value_at(i % 11, i / 11));
    EXPECT_TRUE(read.notes.empty());
}

TEST_F(RasterFiles, WithoutAPlaceAreStretchedFromCornerToCorner) {
    write_tif("a.tif", {21, 5});
    write_vrt("plain.vrt", {21, 5}, band_of("a.tif"));
    const io::RasterValues read = io::read_raster_values(path("plain.vrt"), {11, 9, 100, 100}, at_corner);
    for (int row = 0; row < 9; row += 2)
        for (int column = 0; column < 11; ++column)
            EXPECT_EQ(read.values[static_cast<std::size_t>(row) * 11 + column],
                      value_at(2 * column, row / 2));
    ASSERT_EQ(read.notes.size(), 1U);
    EXPECT_NE(read.notes[0].find("stretched"), std::string::npos);
}

// Twice as coarse, and two samples further east and one further south than the terrain's corner.
TEST_F(RasterFiles, WithAPlaceAreLaidThere) {
    write_tif("a.tif", {4, 30}, Georeference{"", {500200, 200, 0, 3799900, 0, -200}});
    const io::RasterValues read = io::read_raster_values(path("a.tif"), {11, 9, 100, 100}, at_corner);
    for (int row = 0; row < 9; ++row)
        for (int column = 0; column < 11; ++column) {
            const float value = read.values[static_cast<std::size_t>(row) * 11 + column];
            const bool covered = column >= 2 && column < 10 && row >= 1;
            EXPECT_EQ(std::isnan(value), !covered) << column << " " << row;
            EXPECT_TRUE(!covered || value == value_at((column - 2) / 2, (row - 1) / 2))
                << column << " " << row;
        }
    ASSERT_EQ(read.notes.size(), 1U);
    EXPECT_NE(read.notes[0].find("35 of 99"), std::string::npos) << read.notes[0];
    EXPECT_NE(refusal("a.tif", Georeference{"", {700000, 100, 0, 3800000, 0, -100}}).find("beside"),
              std::string::npos);
}

// In degrees over a terrain in metres: each sample has the pixel that its place on Earth lies in.
TEST_F(RasterFiles, OfAnotherCoordinateSystemAreLaidWhereTheyLie) {
    write_tif("a.tif", {400, 400});
    write_vrt("degrees.vrt", {400, 400},
              "<SRS>EPSG:4326</SRS><GeoTransform>-117.05,0.00025,0,34.38,0,-0.00025</GeoTransform>" +
                  band_of("a.tif"));
    write_vrt(
        "metres.vrt", {11, 9},
        "<SRS>EPSG:32611</SRS><GeoTransform>500000,100,0,3800000,0,-100</GeoTransform>" + band_of("a.tif"));
    const io::Heightmap ground = io::read_heightmap(path("metres.vrt"), {});
    ASSERT_TRUE(ground.georeference);
    const io::RasterValues read =
        io::read_raster_values(path("degrees.vrt"), {11, 9, 100, 100}, ground.georeference);
    // 500 km east lies on the zone's middle, 117° W. A metre east is 1/92,000 of a degree there, one north
    // 1/110,930; 3,800 km north lies at 34.3412°.
    const auto place = [&](int column, int row) {
        const float coded = read.values[static_cast<std::size_t>(row) * 11 + column] * 16384;
        return glm::dvec2(std::fmod(coded, 100.0F), std::floor(coded / 100));
    };
    EXPECT_TRUE(read.notes.empty());
    // 900 m, of which a pixel has 27.7 or 23.0.
    EXPECT_NEAR((place(0, 8) - place(0, 0)).y, 800 / 27.73, 1.01);
    const double columns = (place(9, 0) - place(0, 0)).x;
    EXPECT_NEAR(columns < 0 ? columns + 100 : columns, 900 / 22.98, 1.01);
}

TEST_F(RasterFiles, SayNothingWhereTheySaySo) {
    write_tif("a.tif", {11, 9});
    const std::string nodata = fmt::format("<NoDataValue>{}</NoDataValue>", value_at(5, 0));
    write_vrt("b.vrt", {11, 9}, band_of("a.tif", nodata));
    write_vrt("placed.vrt", {11, 9},
              "<GeoTransform>500000,100,0,3800000,0,-100</GeoTransform>" + band_of("a.tif", nodata));
    for (const char* name : {"b.vrt", "placed.vrt"}) {
        const io::RasterValues read = io::read_raster_values(path(name), {11, 9, 100, 100}, at_corner);
        for (int i = 0; i < 99; ++i) {
            const float value = read.values[static_cast<std::size_t>(i)];
            EXPECT_EQ(std::isnan(value), i == 5) << name << " " << i;
            EXPECT_TRUE(i == 5 || value == value_at(i % 11, i / 11)) << name << " " << i;
        }
    }
    // Rows that run northwards, columns that run westwards.
    write_vrt("turned.vrt", {11, 9}, "<GeoTransform>0,-100,0,0,0,100</GeoTransform>" + band_of("a.tif"));
    const io::RasterValues turned = io::read_raster_values(path("turned.vrt"), {11, 9, 100, 100}, {});
    EXPECT_EQ(turned.values[0], value_at(10, 8));
    // One of both has a place on Earth: that is said.
    write_vrt(
        "earth.vrt", {11, 9},
        "<SRS>EPSG:32611</SRS><GeoTransform>500000,100,0,3800000,0,-100</GeoTransform>" + band_of("a.tif"));
    EXPECT_EQ(io::read_raster_values(path("earth.vrt"), {11, 9, 100, 100}, {}).notes.size(), 1U);
    write_vrt("scaled.vrt", {11, 9}, band_of("a.tif", "<Offset>3</Offset><Scale>0.5</Scale>"));
    EXPECT_FLOAT_EQ(io::read_raster_values(path("scaled.vrt"), {11, 9, 100, 100}, {}).values[20],
                    3 + 0.5F * value_at(9, 1));
}

TEST_F(RasterFiles, RefuseWhatIsNone) {
    write_tif("a.tif", {11, 9});
    write_vrt("two.vrt", {11, 9}, band_of("a.tif") + band_of("a.tif", "", 2));
    EXPECT_NE(refusal("two.vrt").find("2 bands"), std::string::npos);
    EXPECT_NE(refusal("none.tif").find("no such file"), std::string::npos);
    write_vrt("wide.vrt", {2000000000, 1}, band_of("a.tif"));
    EXPECT_NE(refusal("wide.vrt").find("2000000000 pixels"), std::string::npos);
    std::ofstream(path("words.tif")) << "no raster";
    EXPECT_NE(refusal("words.tif"), "");
    write_vrt("gone.vrt", {11, 9}, band_of("gone.tif"));
    EXPECT_NE(refusal("gone.vrt"), "");
    fs::resize_file(path("a.tif"), fs::file_size(path("a.tif")) / 2);
    EXPECT_NE(refusal("a.tif"), "");
}

}  // namespace
}  // namespace talus::land_cover_test
