// Nothing is lost: whatever was done, in any order, undo and redo lead back and forth to the bit, within
// their memory.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <random>

#include "sim/error.h"
#include "sim/gpu/context.h"
#include "sim/simulation.h"
#include "sim/simulation_parameters.h"
#include "sim/terrain/bed_beyond.h"
#include "sim/terrain/generate.h"
#include "sim/terrain/state_hash.h"

namespace talus::history_test {
namespace {

int wanted(const char* name, int otherwise) {
    const char* text = std::getenv(name);
    return text ? std::atoi(text) : otherwise;
}

// Every other one knows the ground beyond its edges.
TerrainState mountains(int nx, int ny, std::uint32_t seed) {
    const Grid grid{nx, ny, 20, 25};
    TerrainState state = bedrock_terrain(grid, generate_heights(grid, {"mountains", seed, 900}));
    if (seed % 2 != 0)
        state.bed_beyond =
            bed_beyond_of(grid, [](glm::ivec2 at) { return static_cast<float>(300 + 5 * at.x - 7 * at.y); });
    return state;
}

// An import of a file that is not there: its hash says what it holds.
Import other_mountains(const Source& source) {
    const auto seed = static_cast<std::uint32_t>(source.hash);
    return {source, std::make_shared<TerrainState>(mountains(90 + static_cast<int>(seed % 20), 80, seed))};
}

// Acts of every kind.
class RandomActs {
  public:
    explicit RandomActs(unsigned seed) : random_(seed) {}
    std::mt19937& random() { return random_; }
    double unit() { return std::uniform_real_distribution<double>(0, 1)(random_); }

    Dab dab(const Grid& grid, bool has_stamp) {
        Dab dab;
        dab.effect = effect_of(static_cast<BrushMode>(random_() % 9));
        if (dab.mode() == BrushMode::stamp && !has_stamp) dab.effect = RaiseDab{};
        dab.material = static_cast<Material>(random_() % 6);
        dab.x_m = grid.width_m() * (1.2 * unit() - 0.1);
        dab.y_m = grid.height_m() * (1.2 * unit() - 0.1);
        dab.radius_m = 20 + 500 * unit();
        dab.falloff = unit();
        dab.curve = static_cast<FalloffCurve>(random_() % 4);
        dab.amount_m = 20 * unit();
        dab.blend = unit();
        dab.target_m = dab.is_paint() ? unit() * (dab.material == Material::rain ? 500 : 1) : 900 * unit();
        dab.masked = random_() % 3 == 0 && dab.material != Material::mask;
        if (auto* ramp = dab.as<RampDab>())
            *ramp = {{600 * (unit() - 0.5), 600 * (unit() - 0.5)}, 100 * (unit() - 0.5)};
        if (auto* terrace = dab.as<TerraceDab>()) terrace->step_m = 5 + 50 * unit();
        if (auto* noise = dab.as<NoiseDab>())
            *noise = {static_cast<int>(random_() % 3),      30 + 300 * unit(), 4, 0.5, 0.2 * unit(),
                      static_cast<std::uint32_t>(random_())};
        if (auto* stamp = dab.as<StampDab>())
            *stamp = {static_cast<StampMode>(random_() % 4),
                      {60 + 200 * unit(), 60 + 200 * unit()},
                      360 * unit(),
                      random_() % 2 == 0,
                      unit()};
        if (auto* erode = dab.as<ErodeDab>())
            *erode = {5000 * unit(), 0.5 + 3 * unit(), 1 + 500 * unit(), random_() % 4 == 0,
                      random_() % 4 == 0};
        return dab;
    }

    SetParameter parameter() {
        switch (random_() % 8) {
            case 7:
                return {"thermal.repose_deg", std::nullopt};
            case 0:
                return {"thermal.repose_deg", 20 + 25 * unit()};
            case 1:
                return {"water.rain_mm_per_h", random_() % 2 == 0 ? 0 : 300 * unit()};
            case 2:
                return {"erosion.on", random_() % 2 == 0};
            case 3:
                return {"erosion.porosity", 0.4 * unit()};
            case 4:
                return {"erosion.acceleration", 1 + 50 * unit()};
            case 5:
                return {"water.boundary.east", std::string(random_() % 2 == 0 ? "wall" : "open")};
            default:
                return {"water.sea_level_m", 300 * unit()};
        }
    }

    // A number follows a table from now on, or follows none any more.
    DriveParameter table(double now_s) {
        struct Number {
            const char* name;
            double least;
            double most;
        };
        const std::vector<Number> numbers = {{"water.rain_mm_per_h", 0, 300},
                                             {"water.sea_level_m", 0, 300},
                                             {"water.manning", 0, 0.1},
                                             {"thermal.repose_deg", 10, 40}};
        const Number& number = numbers[random_() % numbers.size()];
        if (random_() % 3 == 0) return {number.name, {}};
        std::vector<TimeSeries::Row> rows;
        rows.reserve(8);
        for (int i = 0; i < 8; ++i)
            rows.push_back(
                {now_s + i * (0.1 + unit()), number.least + (number.most - number.least) * unit()});
        std::sort(rows.begin(), rows.end(), [](const auto& a, const auto& b) { return a.time_s < b.time_s; });
        return {number.name, TimeSeries(std::move(rows))};
    }

    // One entry of undo.
    void act(Simulation& simulation) {
        const Grid grid = simulation.terrain().grid();
        const bool has_stamp = simulation.stamp() != nullptr;
        const unsigned kind = random_() % 20;
        if (kind < 6) {
            simulation.begin_stroke("stroke");
            for (int i = 0; i < 4; ++i) simulation.apply(dab(grid, has_stamp));
            simulation.end_entry();
        } else if (kind < 9) {
            simulation.apply(dab(grid, has_stamp));
        } else if (kind < 12) {
            simulation.apply(Ticks{1 + static_cast<int>(random_() % 4)});
            simulation.end_entry();
        } else if (kind == 12) {
            simulation.apply(parameter());
        } else if (kind == 13) {
            if (random_() % 2 == 0) return simulation.apply(table(simulation.clock().simulated_s));
            simulation.apply(PlaceSpring{grid.width_m() * unit(), grid.height_m() * unit(), 5 * unit()});
        } else if (kind == 14) {
            reshape(simulation);
        } else if (kind == 15) {
            const double x = grid.width_m() * unit() * 0.7;
            const double y = grid.height_m() * unit() * 0.7;
            simulation.apply(ChooseStamp{{}, {x, y, x + 300, y + 250}, nullptr});
        } else if (kind == 16) {
            const double low = 800 * unit();
            simulation.apply(MakeMask{static_cast<MaskSource>(random_() % 6), low / 20, low / 20 + 30,
                                      5 * unit(), static_cast<MaskJoin>(random_() % 4), random_() % 2 == 0});
        } else if (kind == 17) {
            simulation.apply(Blur{10 + 50 * unit(), random_() % 2 == 0, random_() % 2 == 0});
        } else {
            simulation.apply(everywhere(grid, dab(grid, has_stamp)));
        }
    }

    void reshape(Simulation& simulation) {
        const Grid grid = simulation.terrain().grid();
        switch (random_() % 4) {
            case 0:
                return simulation.apply(
                    Resample{40 + static_cast<int>(random_() % 90), 40 + static_cast<int>(random_() % 90)});
            case 1:
                if (grid.nx < 60 || grid.ny < 60) return;
                return simulation.apply(Crop{{grid.width_m() * 0.1 * unit(), grid.height_m() * 0.1 * unit(),
                                              grid.width_m(), grid.height_m() * (0.9 + 0.1 * unit())}});
            case 2:
                return simulation.apply(Turn{1 + static_cast<int>(random_() % 3)});
            default:
                simulation.apply(other_mountains({"other.tif", "", random_() % 100}));
        }
    }

  private:
    std::mt19937 random_;
};

// What a state is told by. The ledger goes back with it.
struct Seen {
    std::uint64_t hash = 0;
    double solid_initial = 0;
    double solid_in = 0;
    bool operator==(const Seen&) const = default;
};

Seen seen(Simulation& simulation) {
    const LedgerReading ledger = simulation.ledger();
    return {state_hash(simulation.read()), ledger.solid_initial, ledger.solid_in};
}

TEST(History, UndoOfRandomActsLeadsBackAndRedoForthToTheBit) {
    const gpu::Context context;
    const int acts = wanted("TALUS_SOAK_ACTS", 500);
    // Room for all of them: an act changes half a megabyte at most.
    const std::size_t capacity = std::max(std::size_t{1} << 30U, static_cast<std::size_t>(acts) << 19U);
    Simulation simulation(mountains(100, 75, 3), Parameters(simulation_parameters()), capacity);
    RandomActs random(20261124);
    std::vector<Seen> states = {seen(simulation)};  // after so many entries that are done
    const auto done = [&] { return simulation.undo_history().done().size(); };
    int undone = 0;
    for (int i = 0; i < acts; ++i) {
        if (random.random()() % 4 == 0) {
            for (unsigned n = random.random()() % 4; n > 0 && simulation.can_undo(); --n, ++undone) {
                simulation.undo();
                ASSERT_EQ(seen(simulation), states[done()]) << "act " << i;
            }
            for (unsigned n = random.random()() % 3; n > 0 && simulation.can_redo(); --n) simulation.redo();
            ASSERT_EQ(seen(simulation), states[done()]) << "act " << i;
        }
        random.act(simulation);
        simulation.poll_undo();
        if (simulation.can_redo()) continue;  // it was no act
        states.resize(done());
        states.push_back(seen(simulation));
    }
    EXPECT_GT(undone, acts / 6);
    ASSERT_LT(simulation.undo_history().bytes(), capacity / 2) << "entries may have been dropped";
    const std::vector<Operation> operations = simulation.journal().operations();
    while (simulation.can_undo()) simulation.undo();
    EXPECT_EQ(seen(simulation), states.front());
    EXPECT_TRUE(simulation.journal().operations().empty());
    while (simulation.can_redo()) simulation.redo();
    EXPECT_EQ(seen(simulation), states.back());
    EXPECT_EQ(simulation.journal().operations(), operations);

    Simulation replayed(mountains(100, 75, 3), Parameters(simulation_parameters()));
    for (Operation& operation : read_journal(write_journal({}, simulation.journal()), "journal").operations) {
        if (auto* import = std::get_if<Import>(&operation)) *import = other_mountains(import->source);
        replayed.apply(operation);
    }
    EXPECT_EQ(seen(replayed), states.back());
}

TEST(History, StaysUnderItsCap) {
    const gpu::Context context;
    constexpr std::size_t cap = std::size_t{6} << 20U;
    Simulation simulation(mountains(100, 75, 4), Parameters(simulation_parameters()), cap);
    RandomActs random(5);
    std::size_t largest = 0;
    const int acts = wanted("TALUS_SOAK_ACTS", 200);
    for (int i = 0; i < acts; ++i) {
        random.act(simulation);
        simulation.settle_undo();
        largest = std::max(largest, simulation.undo_history().bytes());
        ASSERT_LE(simulation.undo_history().bytes(), cap);
    }
    EXPECT_GT(largest, cap / 2) << "the cap was never near";
    EXPECT_GT(simulation.undo_history().done().size(), 5U);
    EXPECT_LT(simulation.undo_history().done().size(), static_cast<std::size_t>(acts));
}

TEST(History, AStrokeThatDidNothingTakesNoRedo) {
    const gpu::Context context;
    Simulation simulation(mountains(70, 70, 6), Parameters(simulation_parameters()), std::size_t{1} << 30U);
    simulation.apply(everywhere(simulation.terrain().grid(), Dab{RaiseDab{}, 0, 0, 1, 1, 12}));
    const Seen raised = seen(simulation);
    simulation.undo();
    simulation.begin_stroke("raise");
    simulation.end_entry();
    ASSERT_TRUE(simulation.can_redo());
    simulation.redo();
    EXPECT_EQ(seen(simulation), raised);
    simulation.undo();
    simulation.begin_stroke("lower");
    simulation.apply(everywhere(simulation.terrain().grid(), Dab{LowerDab{}, 0, 0, 1, 1, 12}));
    simulation.end_entry();
    EXPECT_FALSE(simulation.can_redo());
}

// What a thread made ready is what the act makes itself.
TEST(History, ActsThatWereMadeReadyAreTheSame) {
    const gpu::Context context;
    const Operation acts[] = {Resample{90, 60},       Crop{{100, 200, 900, 1000}}, Turn{1},
                              Blur{40, false, false}, Blur{40, false, true},       Blur{30, true, false}};
    for (const Operation& act : acts) {
        ASSERT_TRUE(makes_terrain(act));
        std::vector<std::uint64_t> hashes;
        for (const bool ready : {false, true}) {
            Simulation simulation(mountains(70, 70, 6), Parameters(simulation_parameters()));
            simulation.apply(SetParameter{"water.sea_level_m", 200.0});
            simulation.apply(MakeMask{MaskSource::height, 300, 600, 50});
            simulation.apply(ready ? made_ready(act, simulation.read()) : act);
            hashes.push_back(state_hash(simulation.read()));
        }
        EXPECT_EQ(hashes[0], hashes[1]) << name_of(act);
    }
    EXPECT_FALSE(makes_terrain(Ticks{1}));
}

// A current of -0, as a file may hold and a turn makes, became 0 in a run without being noticed, so that
// undo of the run left it.
TEST(History, ACurrentOfMinusZeroComesBackToo) {
    const gpu::Context context;
    const Grid grid{100, 75, 20, 25};
    TerrainState state = bedrock_terrain(grid, std::vector<float>(grid.count(), 50.0F));
    state.water.assign(grid.count(), glm::vec4(3, 0, -0.0F, -0.0F));
    Parameters parameters((simulation_parameters()));
    for (const char* edge : {"north", "south", "west", "east"})
        parameters.set(std::string("water.boundary.") + edge, std::string("wall"));
    Simulation simulation(state, parameters, std::size_t{1} << 30U);
    const Seen before = seen(simulation);
    simulation.apply(Ticks{1});
    simulation.end_entry();
    simulation.undo();
    EXPECT_EQ(seen(simulation), before);
}

// A sea that fills imported ground was in no inundation map: the first dab of water brought it there, and
// undo left it.
TEST(History, WaterThatComesWithAnImportIsInTheInundationMapAtOnce) {
    const gpu::Context context;
    Simulation simulation(mountains(100, 75, 3), Parameters(simulation_parameters()), std::size_t{1} << 30U);
    simulation.apply(SetParameter{"water.sea_level_m", 300.0});
    simulation.apply(other_mountains({"other.tif", "", 7}));
    const Seen imported = seen(simulation);
    EXPECT_FALSE(simulation.read().inundation.empty());
    Dab dab;
    dab.material = Material::water;
    dab.x_m = dab.y_m = 700;
    dab.radius_m = 100;
    dab.amount_m = 1;
    simulation.apply(dab);
    EXPECT_FALSE(seen(simulation) == imported);
    simulation.undo();
    EXPECT_EQ(seen(simulation), imported);
}

TEST(History, AnActThatFailsLeavesEverythingAsItWas) {
    const gpu::Context context;
    Simulation simulation(mountains(70, 70, 6), Parameters(simulation_parameters()), std::size_t{1} << 30U);
    simulation.apply(everywhere(simulation.terrain().grid(), Dab{RaiseDab{}, 0, 0, 1, 1, 12}));
    const Seen before = seen(simulation);
    Dab stamp;
    stamp.effect = StampDab{};
    const Operation wrong[] = {Resample{1, 40},
                               Resample{100000, 40},
                               Crop{{500, 0, 400, 900}},
                               Crop{{-90, -90, -50, -50}},
                               Import{{"missing.tif", "", 0}, nullptr},
                               MakeMask{MaskSource::slope, 50, 20},
                               Blur{-1},
                               stamp};
    for (const Operation& operation : wrong) {
        EXPECT_THROW(simulation.apply(operation), Error) << name_of(operation);
        EXPECT_EQ(seen(simulation), before) << name_of(operation);
        EXPECT_EQ(simulation.undo_history().done().size(), 1U) << name_of(operation);
    }
}

}  // namespace
}  // namespace talus::history_test
