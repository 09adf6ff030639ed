// Maps that are written together: read back they are what they were, and weights sum to one.
#include <gtest/gtest.h>
#include <unistd.h>

#include <OpenImageIO/imageio.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <random>

#include "sim/error.h"
#include "sim/io/heightmap.h"
#include "sim/io/map_export.h"
#include "sim/terrain/generate.h"
#include "sim/terrain/layers.h"

namespace talus::map_export_test {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> export_maps(const TerrainState& state, const fs::path& path,
                                  std::vector<std::string> maps, int weight_bits = 0,
                                  io::ExportKind samples_for = io::ExportKind::heightmap) {
    io::ExportSettings settings;
    settings.kind = io::ExportKind::maps;
    settings.path = path;
    settings.maps = std::move(maps);
    settings.weight_bits = weight_bits;
    settings.samples_for = samples_for;
    io::Document document;
    document.state = state;
    return io::export_terrain(document, settings).files;
}

class MapExports : public testing::Test {
  protected:
    MapExports() { fs::create_directories(folder_); }
    ~MapExports() override { fs::remove_all(folder_); }

    nlohmann::json ranges() const {
        std::ifstream file(folder_ / "land.json");
        return nlohmann::json::parse(file);
    }

    fs::path folder_ = fs::temp_directory_path() / ("talus_maps_" + std::to_string(::getpid()));
};

// Rivers, wear and deposition of many sizes, and a map that is empty.
TerrainState worked_on() {
    const Grid grid{70, 50, 4, 5};
    TerrainState state = bedrock_terrain(grid, generate_heights(grid, {"hills", 4, 60}));
    std::mt19937 random(5);
    std::lognormal_distribution<float> amount(0, 3);
    for (std::size_t i = 0; i < grid.count(); ++i) {
        state.flow.emplace_back(100 * amount(random), 0);
        state.worn_by_water.emplace_back(0.1F * amount(random), 0, 0.02F * amount(random), 0);
        state.worn_by_slopes.emplace_back(i % 7 == 0 ? 0.5F : 0.0F, 0, 0, 0);
    }
    return state;
}

std::vector<unsigned> grey_of(const fs::path& path, int bits) {
    const auto input = OIIO::ImageInput::open(path.string());
    if (!input) return {};
    EXPECT_EQ(input->spec().nchannels, 1);
    EXPECT_EQ(input->spec().format.size() * 8, static_cast<std::size_t>(bits));
    std::vector<std::uint16_t> values(input->spec().image_pixels());
    input->read_image(0, 0, 0, 1, OIIO::TypeDesc::UINT16, values.data());
    std::vector<unsigned> grey(values.begin(), values.end());
    // 8 bits come as 16: every value times 257.
    if (bits == 8)
        for (unsigned& value : grey) value /= 257;
    return grey;
}

TEST_F(MapExports, AreReadBackWithinHalfAStep) {
    const TerrainState state = worked_on();
    const std::vector<std::string> maps = {"ground", "flow",      "wear",     "deposition",
                                           "slope",  "curvature", "depth_max"};
    for (const char* ending : {".png", ".tif", ".exr"}) {
        const std::vector<fs::path> files =
            export_maps(state, folder_ / (std::string("land") + ending), maps);
        ASSERT_EQ(files.size(), maps.size() + 1);
        const nlohmann::json said = ranges();
        EXPECT_EQ(said["columns"], 70);
        for (std::size_t i = 0; i < maps.size(); ++i) {
            const nlohmann::json& map = said["maps"][i];
            EXPECT_EQ(map["map"], maps[i]);
            EXPECT_EQ(folder_ / map["file"], files[i]);
            const std::vector<float> expected = output_of(state, maps[i]);
            const io::Heightmap read = io::read_heightmap(files[i], {});
            ASSERT_EQ(read.heights.size(), expected.size());
            const double step = map.value("step", 0.0);
            EXPECT_EQ(step > 0, std::string(ending) == ".png") << ending;
            for (std::size_t k = 0; k < expected.size(); ++k)
                ASSERT_NEAR(read.heights[k], expected[k], 0.5 * step + 1e-6 * std::abs(expected[k]))
                    << maps[i] << ending;
        }
    }
}

TEST_F(MapExports, WeightsSumToOneAtEverySample) {
    const TerrainState state = worked_on();
    for (const int bits : {8, 16})
        for (const io::ExportKind engine :
             {io::ExportKind::heightmap, io::ExportKind::unreal, io::ExportKind::unity}) {
            const std::vector<fs::path> files = export_maps(
                state, folder_ / "land.png", {"flow", "wear", "deposition", "slope"}, bits, engine);
            ASSERT_EQ(files.size(), 6U) << "four maps, the rest and what they hold";
            std::vector<unsigned> sums;
            std::vector<unsigned> largest;
            for (std::size_t k = 0; k < 5; ++k) {
                const std::vector<unsigned> grey = grey_of(files[k], bits);
                sums.resize(grey.size());
                for (std::size_t i = 0; i < grey.size(); ++i) sums[i] += grey[i];
                largest.push_back(*std::max_element(grey.begin(), grey.end()));
            }
            EXPECT_EQ(sums.size(), engine == io::ExportKind::heightmap ? 3500U
                                   : engine == io::ExportKind::unreal  ? 127U * 127U
                                                                       : 65U * 65U);
            for (const unsigned sum : sums) ASSERT_EQ(sum, (1U << static_cast<unsigned>(bits)) - 1);
            for (const unsigned most : largest) EXPECT_GT(most, 20U);
        }
}

// By hand: what fits stays as it is, what does not is scaled, and no weight is off by more than 1.
TEST_F(MapExports, WeightsAreTheirShares) {
    std::mt19937 random(8);
    std::uniform_real_distribution<float> unit(0, 1);
    std::vector<std::vector<float>> shares(3, std::vector<float>(1000));
    for (auto& plane : shares)
        for (float& share : plane) share = random() % 4 == 0 ? 0.0F : 0.8F * unit(random);
    for (const int sum : {255, 65535}) {
        const auto weights = io::weights_of(shares, sum);
        ASSERT_EQ(weights.size(), 4U);
        for (std::size_t i = 0; i < 1000; ++i) {
            const double all = static_cast<double>(shares[0][i]) + shares[1][i] + shares[2][i];
            int whole = 0;
            for (std::size_t k = 0; k < 4; ++k) {
                const double share = k < 3 ? shares[k][i] / std::max(1.0, all) : std::max(0.0, 1 - all);
                EXPECT_NEAR(weights[k][i], share * sum, 1);
                whole += weights[k][i];
            }
            EXPECT_EQ(whole, sum);
        }
    }
    EXPECT_EQ(io::shares_of("mask", {0, 0.25F, 1}), (std::vector<float>{0, 0.25F, 1}));
    const std::vector<float> flow = io::shares_of("flow", {0, 1, 100, 1e4F, 1e-3F});
    EXPECT_EQ(flow[0], 0);
    EXPECT_NEAR(flow[1], 0, 1e-6);
    EXPECT_NEAR(flow[2], 0.5, 1e-6);
    EXPECT_EQ(flow[3], 1);
    EXPECT_EQ(flow[4], 0);
    // One sample in a thousand has any.
    std::vector<float> rare(1000, 0.0F);
    rare[3] = 5;
    EXPECT_EQ(io::shares_of("wear", rare)[3], 1);
    EXPECT_EQ(io::shares_of("wear", std::vector<float>(9, 0.0F))[3], 0);
    EXPECT_EQ(io::shares_of("flow", std::vector<float>(9, 0.0F))[3], 0);
}

// For an engine ground and level are resampled as surfaces, layers as they are: a lake stays level, and flow
// is nowhere below 0 and passes its narrower samples.
TEST_F(MapExports, LayersForEnginesStayWhatTheyAre) {
    TerrainState state = worked_on();
    for (std::size_t i = 0; i < state.grid.count(); ++i)
        state.water.emplace_back(std::max(0.0F, 200 - state.bedrock[i].x), 0, 0, 0);
    io::Document document;
    document.state = state;
    io::ExportSettings settings;
    settings.kind = io::ExportKind::unreal;
    settings.path = folder_ / "lake.r16";
    settings.layer = "level";
    const io::Exported lake = io::export_terrain(document, settings);
    EXPECT_NEAR(lake.range_m.x, 200, 1e-3);
    EXPECT_NEAR(lake.range_m.y, 201, 1e-3) << "one step of a level that is the same everywhere";
    settings.layer = "flow";
    const io::Exported flow = io::export_terrain(document, settings);
    const std::vector<float> there = output_of(state, "flow");
    const auto high = std::max_element(there.begin(), there.end());
    EXPECT_GE(flow.range_m.x, 0);
    // 127 samples in the place of 70 and of 50; none need lie at the largest.
    const double share = flow.range_m.y / (*high * std::sqrt(69.0 * 49 / (126 * 126)));
    EXPECT_GT(share, 0.5);
    EXPECT_LE(share, 1 + 1e-6);
}

TEST_F(MapExports, RefuseWhatTheyCannotWrite) {
    const TerrainState state = worked_on();
    const auto refused = [&](const fs::path& path, const std::vector<std::string>& maps, int bits,
                             const std::string& because) {
        try {
            export_maps(state, path, maps, bits);
            ADD_FAILURE() << because;
        } catch (const Error& error) {
            EXPECT_NE(std::string(error.what()).find(because), std::string::npos) << error.what();
        }
        EXPECT_TRUE(fs::is_empty(folder_)) << because;
    };
    refused(folder_ / "land.png", {}, 0, "no maps");
    refused(folder_ / "land.png", {"flow", "lava"}, 0, "'lava'");
    refused(folder_ / "land.png", {"flow", "flow"}, 0, "twice");
    refused(folder_ / "land.png", {"flow"}, 12, "12 bits");
    refused(folder_ / "land.tif", {"flow"}, 8, ".png");
    refused(folder_ / "land.jpg", {"flow"}, 0, "its ending");
}

// Of a plane and a ridge, to what one computes by hand.
TEST(GroundShape, SlopeAndCurvatureAreOutputs) {
    const Grid grid{21, 11, 10, 20};
    std::vector<float> heights;
    for (int y = 0; y < grid.ny; ++y)
        for (int x = 0; x < grid.nx; ++x)
            heights.push_back(1000 - 5.0F * static_cast<float>(std::abs(x - 10)));
    const TerrainState state = bedrock_terrain(grid, heights);
    const std::vector<float> slope = output_of(state, "slope");
    const std::vector<float> curvature = output_of(state, "curvature");
    const std::size_t row = 5 * 21;
    EXPECT_NEAR(slope[row + 4], std::atan(0.5) * 180 / 3.14159265358979, 1e-4);
    EXPECT_EQ(slope[row + 10], 0);
    EXPECT_NEAR(curvature[row + 10], 100, 1e-3) << "10 m down over 10 m to both sides, positive on a crest";
    EXPECT_NEAR(curvature[row + 4], 0, 1e-3);
    EXPECT_EQ(output_unit("slope"), "°");
    EXPECT_EQ(output_unit("flow"), "m³");
    EXPECT_EQ(output_unit("ground"), "m");
}

}  // namespace
}  // namespace talus::map_export_test
