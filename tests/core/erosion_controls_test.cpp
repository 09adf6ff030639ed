// Controls of erosion in an artist's words: they set what they say, do what they say, and are one act each.
#include "app/core/erosion_controls.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "app/core/session.h"
#include "sim/error.h"
#include "sim/gpu/context.h"
#include "sim/simulation_parameters.h"
#include "sim/terrain/generate.h"
#include "sim/terrain/layers.h"
#include "sim/terrain/state_hash.h"

namespace talus::erosion_controls_test {
namespace {

using app::ErosionControl;
using app::ErosionPreset;

Parameters parameters() {
    return Parameters(simulation_parameters());
}

void set_all(Parameters& p, const std::vector<SetParameter>& changes) {
    for (const SetParameter& one : changes) p.set(one.name, one.value.value());
}

const ErosionControl& control_named(const std::string& name) {
    return *std::find_if(app::erosion_controls().begin(), app::erosion_controls().end(),
                         [&](const ErosionControl& one) { return one.name == name; });
}

TEST(ErosionControls, StandWhereTheyWereMoved) {
    for (const ErosionControl& control : app::erosion_controls())
        for (const double position : {0.0, 0.1, 0.5, 0.77, 1.0}) {
            Parameters p = parameters();
            set_all(p, moved_to(control, position, p));
            // Numbers are rounded to three digits.
            EXPECT_NEAR(position_of(control, p), position, 2e-3) << control.name;
        }
}

TEST(ErosionControls, StrengthKeepsWhatSetsRockApart) {
    Parameters p = parameters();
    p.set("erosion.erodibility", 5.0);
    p.set("erosion.bedrock_erodibility", 0.2);
    set_all(p, moved_to(control_named("Strength"), 0.9, p));
    EXPECT_NEAR(p.number("erosion.erodibility") / p.number("erosion.bedrock_erodibility"), 25, 0.3);
    EXPECT_GT(p.number("erosion.erodibility"), 50);
    // Of what was 0 no factor is known.
    p.set("erosion.erodibility", 0.0);
    p.set("erosion.bedrock_erodibility", 4.0);
    set_all(p, moved_to(control_named("Strength"), 0.9, p));
    EXPECT_EQ(p.number("erosion.bedrock_erodibility"), 4);
}

TEST(ErosionControls, PresetsAreKnownByWhatTheySet) {
    const Grid grid{65, 65, 3, 5};
    for (const std::vector<ErosionPreset>* presets : {&app::climates(), &app::rocks()})
        for (const ErosionPreset& one : *presets) {
            Parameters p = parameters();
            set_all(p, settings_of(one, p, grid));
            EXPECT_EQ(present_of(*presets, p), &one) << one.name;
            p.set(one.assignments.front().substr(0, one.assignments.front().find('=')), 0.123);
            EXPECT_NE(present_of(*presets, p), &one) << one.name;
        }
    Parameters p = parameters();
    set_all(p, settings_of(app::climates()[1], p, grid));
    EXPECT_TRUE(p.toggle("erosion.on"));
    EXPECT_EQ(p.number("time.tick_s"), 0.1);
    p.set("time.tick_s", 0.7);
    set_all(p, settings_of(app::climates()[2], p, grid));
    EXPECT_EQ(p.number("time.tick_s"), 0.7) << "a length that somebody set stays";
}

TEST(ErosionControls, SayWhyNothingErodes) {
    Parameters p = parameters();
    EXPECT_EQ(app::why_nothing_erodes(p, false, false), "");
    p.set("erosion.on", true);
    EXPECT_NE(app::why_nothing_erodes(p, false, false).find("there is no water"), std::string::npos);
    EXPECT_EQ(app::why_nothing_erodes(p, true, false), "");
    p.set("water.rain_mm_per_h", 20.0);
    EXPECT_EQ(app::why_nothing_erodes(p, false, false), "");
    p.set("water.rain_mm_per_h", 0.0);
    p.set("water.boundary.west", std::string("level"));
    EXPECT_EQ(app::why_nothing_erodes(p, false, false), "");
    p.set("erosion.over", std::string("mask"));
    EXPECT_NE(app::why_nothing_erodes(p, true, false).find("mask"), std::string::npos);
    EXPECT_EQ(app::why_nothing_erodes(p, true, true), "");
    p.set("water.manning", 0.0);
    EXPECT_NE(app::why_nothing_erodes(p, true, false).find("Manning's n"), std::string::npos);
    p.set("water.on", false);
    EXPECT_NE(app::why_nothing_erodes(p, true, false).find("off"), std::string::npos);
}

// What a minute of a storm did to an upland, with a control moved.
struct Eroded {
    double worn_m = 0;  // summed over samples
    double laid_m = 0;
    double cut_share = 0;  // of the samples, where water took more than a centimetre
};

Eroded eroded(const std::string& control, double position) {
    const Grid grid{129, 129, 15, 15};
    Parameters p = parameters();
    for (const char* assignment : {"erosion.critical_shear_pa=20", "erosion.settling_mm_per_s=30",
                                   "erosion.porosity=0.3", "erosion.acceleration=30", "water.manning=0.05"})
        p.set_assignment(assignment);
    set_all(p, settings_of(app::climates()[1], p, grid));
    set_all(p, settings_of(app::rocks()[2], p, grid));
    set_all(p, moved_to(control_named(control), position, p));
    const TerrainState state = bedrock_terrain(grid, generate_heights(grid, {"massif", 3, 400}));
    Simulation simulation(state, p);
    simulation.apply(Ticks{120});
    const TerrainState after = simulation.read();
    const std::vector<float> wear = output_of(after, "wear");
    const std::vector<float> deposition = output_of(after, "deposition");
    Eroded done;
    done.worn_m = std::accumulate(wear.begin(), wear.end(), 0.0);
    done.laid_m = std::accumulate(deposition.begin(), deposition.end(), 0.0);
    const std::vector<float> cut = output_of(after, "wear_by_water");
    done.cut_share = static_cast<double>(
                         std::count_if(cut.begin(), cut.end(), [](float one_m) { return one_m > 0.01F; })) /
                     static_cast<double>(grid.count());
    return done;
}

TEST(ErosionControlsAtWork, DoWhatTheySay) {
    const gpu::Context context;
    for (const char* control : {"Strength", "Age"}) {
        const double weak_m = eroded(control, 0.3).worn_m;
        const double strong_m = eroded(control, 0.8).worn_m;
        EXPECT_GT(weak_m, 0) << control;
        EXPECT_GT(strong_m, 3 * weak_m) << control;
    }
    const Eroded gullies = eroded("Scale of valleys", 0.2);
    const Eroded wide = eroded("Scale of valleys", 0.8);
    EXPECT_LT(wide.cut_share, gullies.cut_share / 2);
    EXPECT_GT(wide.worn_m, 0);
    const Eroded washed = eroded("Sediment", 0.2);
    const Eroded piled = eroded("Sediment", 0.8);
    EXPECT_GT(piled.laid_m / piled.worn_m, 2 * washed.laid_m / washed.worn_m);
}

TEST(ErosionControlsAtWork, AreOneActEach) {
    const gpu::Context context;
    app::SceneRequest request;
    request.preset = "blank";
    request.size = glm::ivec2(65, 65);
    app::Session session(request, context.device());
    const Parameters before = session.simulation().parameters();
    const std::uint64_t hash = state_hash(session.simulation().read());
    const auto together = [&](const std::string& name, const std::vector<SetParameter>& changes) {
        session.apply_together(name, {changes.begin(), changes.end()});
    };
    together("Monsoon", settings_of(app::climates()[2], session.simulation().parameters(), session.grid()));
    together("Strength", moved_to(control_named("Strength"), 0.9, session.simulation().parameters()));
    EXPECT_EQ(session.simulation().undo_history().done(), (std::vector<std::string>{"Monsoon", "Strength"}));
    session.undo();
    session.undo();
    EXPECT_EQ(session.simulation().parameters(), before);
    EXPECT_EQ(state_hash(session.simulation().read()), hash);

    // Where the first cannot be done, what was undone can be done again.
    EXPECT_THROW(session.apply_together("none", {SetParameter{"thermal.rate_m2_per_s", 1e12}}), Error);
    EXPECT_TRUE(session.simulation().can_redo());
    // One that cannot be done takes the others with it.
    EXPECT_THROW(session.apply_together("half", {SetParameter{"water.rain_mm_per_h", 30.0},
                                                 SetParameter{"thermal.rate_m2_per_s", 1e12}}),
                 Error);
    EXPECT_EQ(session.simulation().parameters(), before);
    EXPECT_FALSE(session.simulation().can_undo());
    EXPECT_TRUE(session.simulation().journal().operations().empty());
}

// Erosion in a rectangle that is drawn: nothing is taken beside it, though debris may come to rest there.
TEST(ErosionControlsAtWork, StayWithinADrawnRectangle) {
    const gpu::Context context;
    app::SceneRequest request;
    request.preset = "rain-erosion";
    request.size = glm::ivec2(129, 129);
    app::Session session(request, context.device());
    const Grid grid = session.grid();
    const glm::dvec2 size(grid.width_m(), grid.height_m());
    session.mask_rectangle(0.7 * size, 0.3 * size, true);
    EXPECT_EQ(session.simulation().undo_history().done(), std::vector<std::string>{"mask: rectangle"});
    EXPECT_EQ(session.simulation().parameters().choice("erosion.over"), "mask");
    for (int tick = 0; tick < 40; ++tick) session.step();
    const std::vector<float> wear = output_of(session.simulation().read(), "wear");
    double inside_m = 0;
    double beside_m = 0;
    const double fade_m = 0.4 * std::min(size.x, size.y) / 20;
    for (int y = 0; y < grid.ny; ++y)
        for (int x = 0; x < grid.nx; ++x) {
            const double wear_m = wear[static_cast<std::size_t>(y) * grid.nx + x];
            const glm::dvec2 place(x * grid.dx, (grid.ny - 1 - y) * grid.dy);
            const glm::dvec2 out = glm::max(0.3 * size - place, place - 0.7 * size);
            if (glm::max(out.x, out.y) <= 0) inside_m += wear_m;
            if (glm::max(out.x, out.y) > fade_m + grid.dx) beside_m += wear_m;
        }
    EXPECT_GT(inside_m, 10);
    EXPECT_EQ(beside_m, 0);
}

}  // namespace
}  // namespace talus::erosion_controls_test
