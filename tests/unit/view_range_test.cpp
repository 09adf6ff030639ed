// Where the scales of views end, where they follow what the terrain holds: against the layers themselves.
#include "render/view_range.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "sim/gpu/context.h"
#include "sim/simulation.h"
#include "sim/terrain/generate.h"
#include "sim/terrain/layers.h"
#include "tests/scenes/parameters_with.h"

namespace talus::view_range_test {
namespace {

double end_of(const Terrain& terrain, const std::string& view, const render::OwnNumbers& numbers = {}) {
    render::ViewSettings settings;
    settings.view = view;
    settings.numbers = numbers;
    render::ViewRange range;
    range.start(terrain, settings);
    return range.wait();
}

// Water, solid in it, worn ground, and brushes of what is painted.
void make_everything(Simulation& simulation) {
    Dab dab;
    dab.x_m = 500;
    dab.y_m = 400;
    dab.radius_m = 250;
    dab.amount_m = 30;
    for (const Material material : {Material::bedrock, Material::regolith}) {
        dab.material = material;
        simulation.apply(dab);
    }
    dab.blend = 0.5;
    dab.target_m = 0.07;
    dab.amount_m = 0;
    for (const Material material : {Material::manning, Material::infiltration}) {
        dab.material = material;
        simulation.apply(dab);
    }
    dab.material = Material::rain;
    dab.target_m = 90;
    simulation.apply(dab);
    simulation.apply(Ticks{60});
}

// The largest value that 98 of 100 of the samples stay below that have at least a fiftieth of the largest.
double quantile_of(std::vector<float> values) {
    std::sort(values.begin(), values.end());
    const double largest = values.back();
    std::erase_if(values, [&](float value) { return value < 0.02 * largest; });
    return values[static_cast<std::size_t>(0.98 * static_cast<double>(values.size() - 1))];
}

TEST(ViewRange, EndsWhereTheSamplesOfTheLayerDo) {
    const gpu::Context context;
    const Grid grid{131, 97, 8, 8};
    const TerrainState start = bedrock_terrain(grid, generate_heights(grid, {"mountains", 3, 300}));
    Simulation simulation(start, parameters_with({"time.tick_s=5", "water.rain=300", "erosion.on=true",
                                                  "maps.count=always", "water.manning=0.03"}));
    make_everything(simulation);
    const TerrainState state = simulation.read();
    struct Case {
        const char* view;
        const char* output;
        double factor = 1;  // from the output's unit to the scale's
    };
    for (const Case& one : {Case{"depth", "depth"}, Case{"largest_depth", "depth_max"}, Case{"rain", "rain"},
                            Case{"difference", "difference"}, Case{"suspended", "suspended", 1000},
                            Case{"regolith", "regolith"}, Case{"wear", "wear"},
                            Case{"deposition", "deposition"}, Case{"arrival", "arrival_s"}}) {
        std::vector<float> values = output_of(state, one.output);
        for (float& value : values) value = static_cast<float>(std::abs(one.factor * value));
        // Views of water show none that is less deep than this.
        if (std::string(one.output).starts_with("depth"))
            for (float& value : values) value = value < 0.01F ? 0 : value;
        const double wanted = quantile_of(values);
        ASSERT_GT(wanted, 0) << one.view;
        const double end = end_of(simulation.terrain(), one.view);
        // Values are counted in bins of a sixteenth, and steps are at most half as large again.
        EXPECT_GE(end, wanted * (1 - 1e-5)) << one.view;
        EXPECT_LE(end, wanted * 1.5 * 1.0625 * (1 + 1e-5)) << one.view;
        const double digits = end / std::pow(10, std::floor(std::log10(end) + 1e-9));
        bool is_step = false;
        for (const double step : {1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 6.0, 8.0})
            is_step = is_step || std::abs(digits / step - 1) < 1e-9;
        EXPECT_TRUE(is_step) << one.view << " ends at " << end;
    }
    // By powers of ten.
    const double flow = quantile_of(output_of(state, "flow"));
    const double end = end_of(simulation.terrain(), "flow");
    EXPECT_NEAR(std::log10(end), std::round(std::log10(end)), 1e-9);
    EXPECT_GE(end, flow * (1 - 1e-5));
    EXPECT_LE(end, 10 * flow * 1.0625);
    // A number that is a share of another.
    EXPECT_DOUBLE_EQ(end_of(simulation.terrain(), "manning"), 0.08);
    // Around the middle of its scale: as far as the water reaches from there.
    std::vector<float> levels = output_of(state, "level");
    const std::vector<float> depths = output_of(state, "depth");
    std::vector<float> from_middle;
    for (std::size_t i = 0; i < levels.size(); ++i)
        if (depths[i] >= 0.01F) from_middle.push_back(std::abs(levels[i] - 150));
    const double reach = quantile_of(from_middle);
    const double range = end_of(simulation.terrain(), "level", {{"render.level_m", 150}});
    EXPECT_GE(range, reach * (1 - 1e-5));
    EXPECT_LE(range, reach * 1.5 * 1.0625);
    EXPECT_GT(end_of(simulation.terrain(), "speed"), 0.01);
    EXPECT_LT(end_of(simulation.terrain(), "speed"), 50);
}

TEST(ViewRange, IsNotSetByAFewSamplesNorByAFilm) {
    const gpu::Context context;
    const Grid grid{160, 120, 5, 5};
    TerrainState state = bedrock_terrain(grid, std::vector<float>(grid.count(), 100));
    state.water.assign(grid.count(), glm::vec4(0.012F, 0, 0, 0));
    for (std::size_t i = 0; i < 4000; ++i) state.water[i].x = 2;
    for (std::size_t i = 7000; i < 7040; ++i) state.water[i].x = 90;
    // The film is less than a fiftieth of the largest, and 40 of 4040 are less than two of a hundred.
    EXPECT_DOUBLE_EQ(end_of(Terrain(state), "depth"), 3);
    // All of it, where nothing stands out.
    for (std::size_t i = 7000; i < 7040; ++i) state.water[i].x = 2;
    EXPECT_DOUBLE_EQ(end_of(Terrain(state), "depth"), 2);
    // Nothing where there is nothing, or the layer is not there.
    state.water.assign(grid.count(), glm::vec4(0));
    EXPECT_EQ(end_of(Terrain(state), "depth"), 0);
    state.water.clear();
    EXPECT_EQ(end_of(Terrain(state), "depth"), 0);
    EXPECT_EQ(end_of(Terrain(state), "flow"), 0);
}

}  // namespace
}  // namespace talus::view_range_test
