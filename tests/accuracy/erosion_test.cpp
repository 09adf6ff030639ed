// Rain erosion as a whole, water, sediment and slopes together: no solid is lost, and neither the tick, the
// grid nor its direction decides what it does.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <functional>

#include "sim/gpu/context.h"
#include "sim/simulation.h"
#include "sim/simulation_parameters.h"
#include "sim/terrain/generate.h"
#include "tests/scenes/scenes.h"

namespace talus::erosion_test {
namespace {

using Surface = std::function<double(double, double)>;  // height at x east, y north, m

Parameters rain_erosion(std::initializer_list<const char*> more) {
    Parameters all(simulation_parameters());
    for (const char* assignment :
         {"time.tick_s=1", "thermal.repose_deg=35", "thermal.bedrock_deg=55", "thermal.rate_m2_per_s=2",
          "water.rain=150", "water.manning=0.04", "erosion.on=true", "erosion.erodibility=5",
          "erosion.bedrock_erodibility=1", "erosion.critical_shear=5", "erosion.settling=20",
          "erosion.porosity=0.3", "erosion.acceleration=20"})
        all.set_assignment(assignment);
    for (const char* assignment : more) all.set_assignment(assignment);
    return all;
}

// Real mountains where they are, of 30 m; else generated ones. Height between samples is bilinear.
Surface mountains() {
    static const scenes::Scene scene = scenes::make(std::getenv("TALUS_DATA") ? "bigtujunga" : "ridges");
    return [](double x, double y) {
        const Grid& grid = scene.grid;
        const double column = std::clamp(400 + x / grid.dx, 0.0, grid.nx - 1.001);
        const double row = std::clamp(400 - y / grid.dy, 0.0, grid.ny - 1.001);
        const auto i = static_cast<std::size_t>(column);
        const auto j = static_cast<std::size_t>(row);
        const double u = column - static_cast<double>(i);
        const double v = row - static_cast<double>(j);
        const auto z = [&](std::size_t a, std::size_t b) {
            return static_cast<double>(scene.heights[b * static_cast<std::size_t>(grid.nx) + a]);
        };
        return (1 - v) * ((1 - u) * z(i, j) + u * z(i + 1, j)) +
               v * ((1 - u) * z(i, j + 1) + u * z(i + 1, j + 1));
    };
}

// A quarter of a metre of water lies on it: a cloudburst.
TerrainState under_cloudburst(const Grid& grid, const Surface& surface) {
    std::vector<float> heights;
    heights.reserve(grid.count());
    for (int row = 0; row < grid.ny; ++row)
        for (int column = 0; column < grid.nx; ++column)
            heights.push_back(
                static_cast<float>(surface((column + 0.5) * grid.dx, (grid.ny - row - 0.5) * grid.dy)));
    TerrainState state = bedrock_terrain(grid, heights);
    state.water.assign(grid.count(), glm::vec4(0.25F, 0, 0, 0));
    return state;
}

std::vector<double> change_of(const TerrainState& start, const TerrainState& end) {
    std::vector<double> change;
    change.reserve(start.bedrock.size());
    const auto height = [](const TerrainState& s, std::size_t i) {
        return static_cast<double>(s.bedrock[i].x) + s.bedrock[i].y + s.regolith[i].x + s.regolith[i].y;
    };
    for (std::size_t i = 0; i < start.bedrock.size(); ++i)
        change.push_back(height(end, i) - height(start, i));
    return change;
}

double correlation(const std::vector<double>& a, const std::vector<double>& b) {
    double mean_a = 0;
    double mean_b = 0;
    const auto n = static_cast<double>(a.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
        mean_a += a[i] / n;
        mean_b += b[i] / n;
    }
    double aa = 0;
    double bb = 0;
    double ab = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        aa += (a[i] - mean_a) * (a[i] - mean_a);
        bb += (b[i] - mean_b) * (b[i] - mean_b);
        ab += (a[i] - mean_a) * (b[i] - mean_b);
    }
    return ab / std::sqrt(aa * bb);
}

TEST(Erosion, LosesNoSolid) {
    const gpu::Context context;
    const Grid grid{100, 90, 30, 30};
    const Grid generated{96, 110, 15, 20};
    const std::vector<float> hills = generate_heights(generated, {"hills", 4, 400});
    const struct {
        const char* name;
        TerrainState state;
    } terrains[] = {{"mountains", under_cloudburst(grid, mountains())},
                    {"hills", bedrock_terrain(generated, hills)}};
    for (const auto& [name, state] : terrains) {
        // Closed by walls, in ticks of about a sub-step.
        Simulation simulation(
            state, rain_erosion({"time.tick_s=0.5", "water.boundary.north=wall", "water.boundary.south=wall",
                                 "water.boundary.west=wall", "water.boundary.east=wall"}));
        simulation.apply(Ticks{4000});
        const LedgerReading ledger = simulation.ledger();
        const std::vector<float> ground = state.ground();
        const auto [low, high] = std::minmax_element(ground.begin(), ground.end());
        const double area = state.grid.dx * state.grid.dy * static_cast<double>(state.grid.count());
        fmt::print(
            "{}: net eroded {:.3e} m3, {:.1e} of relief x area; closing error {:.1e} of it, suspended {:.1e} "
            "m3\n",
            name, ledger.eroded_m3, ledger.eroded_m3 / (area * (*high - *low)),
            ledger.closing_error_of_eroded(), ledger.suspended);
        EXPECT_GE(ledger.eroded_m3, 1e-4 * (*high - *low) * area);
        EXPECT_LE(ledger.closing_error_of_eroded(), 1e-5);
        EXPECT_EQ(ledger.solid_edges_out, 0);
    }
}

double eroded_after(const TerrainState& state, const Parameters& parameters, double span_s,
                    std::vector<double>* change = nullptr) {
    Simulation simulation(state, parameters);
    simulation.apply(
        Ticks{static_cast<std::int64_t>(std::lround(span_s / parameters.number("time.tick_s")))});
    if (change) *change = change_of(state, simulation.read());
    return simulation.ledger().eroded_m3;
}

TEST(Erosion, HangsNotOnTheTick) {
    const gpu::Context context;
    const TerrainState state = under_cloudburst({128, 128, 30, 30}, mountains());
    std::vector<double> a;
    std::vector<double> b;
    const double whole = eroded_after(state, rain_erosion({"time.tick_s=4"}), 600, &a);
    const double quarter = eroded_after(state, rain_erosion({"time.tick_s=1"}), 600, &b);
    fmt::print("tick of 4 s against 1 s: net eroded {:+.2f} %, correlation of the change {:.4f}\n",
               100 * (whole / quarter - 1), correlation(a, b));
    EXPECT_NEAR(whole / quarter, 1, 0.05);
}

// Of 128 and 256 samples a side; TALUS_FINEST_SAMPLES asks for more (./dev soak).
TEST(Erosion, HangsNotOnTheGrid) {
    const gpu::Context context;
    const char* asked = std::getenv("TALUS_FINEST_SAMPLES");
    const int finest = asked ? std::stoi(asked) : 256;
    std::array<double, 2> eroded{};
    std::array<std::vector<double>, 2> change;
    for (int fine = 0; fine < 2; ++fine) {
        const int n = fine == 1 ? finest : finest / 2;
        const Grid grid{n, n, 3840.0 / n, 3840.0 / n};
        eroded[fine] = eroded_after(under_cloudburst(grid, mountains()), rain_erosion({"time.tick_s=2"}), 120,
                                    &change[fine]);
    }
    const auto n = static_cast<std::size_t>(finest);
    std::vector<double> coarse(n * n / 4, 0.0);
    for (std::size_t i = 0; i < change[1].size(); ++i)
        coarse[i / n / 2 * (n / 2) + i % n / 2] += change[1][i] / 4;
    fmt::print("{} against {} samples: net eroded {:+.1f} %, correlation of the change {:.3f}\n", n / 2, n,
               100 * (eroded[0] / eroded[1] - 1), correlation(change[0], coarse));
    EXPECT_NEAR(eroded[0] / eroded[1], 1, 0.15);
}

// Shares of the directions that gullies run in, at 0, 22.5 … 157.5 degrees, by the structure tensor over
// seven samples (differences of single samples know only eight directions).
std::array<double, 8> gully_directions(const std::vector<double>& change, int n) {
    std::vector<glm::dvec3> tensor(change.size(), glm::dvec3(0));
    const auto at = [&](int x, int y) { return change[static_cast<std::size_t>(y) * n + x]; };
    for (int y = 1; y < n - 1; ++y)
        for (int x = 1; x < n - 1; ++x) {
            // Scharr's weights: turned as true as three samples can.
            double gx = 0;
            double gy = 0;
            for (int k = -1; k <= 1; ++k) {
                const double weight = k == 0 ? 10 : 3;
                gx += weight * (at(x + 1, y + k) - at(x - 1, y + k));
                gy += weight * (at(x + k, y - 1) - at(x + k, y + 1));
            }
            tensor[static_cast<std::size_t>(y) * n + x] = {gx * gx, gx * gy, gy * gy};
        }
    std::array<double, 8> histogram{};
    double all = 0;
    for (int y = 3; y < n - 3; ++y)
        for (int x = 3; x < n - 3; ++x) {
            glm::dvec3 sum(0);
            for (int j = -3; j <= 3; ++j)
                for (int i = -3; i <= 3; ++i)
                    if (i * i + j * j <= 9) sum += tensor[static_cast<std::size_t>(y + j) * n + x + i];
            const double weight = std::hypot(sum.x - sum.z, 2 * sum.y);
            const double across = 0.5 * std::atan2(2 * sum.y, sum.x - sum.z);
            const double along = across * 180 / std::acos(-1.0) + 90 + 180;
            histogram[static_cast<std::size_t>(std::lround(along / 22.5)) % 8] += weight;
            all += weight;
        }
    for (double& share : histogram) share /= all;
    return histogram;
}

// A dome with hills on it, round about, on a plain that drains it; turned by 45 degrees.
TEST(Erosion, HangsNotOnTheGridsDirection) {
    const gpu::Context context;
    const int n = 256;
    const Grid grid{n, n, 12, 12};
    const Grid noise_grid{400, 400, 12, 12};
    const std::vector<float> noise = generate_heights(noise_grid, {"hills", 12, 80});
    const auto surface = [&](double angle) {
        return [&, angle](double x, double y) {
            const double dx = x - n * 6.0;
            const double dy = y - n * 6.0;
            const double r = std::hypot(dx, dy) / (n * 6.0);
            const double u = 200 + (dx * std::cos(angle) - dy * std::sin(angle)) / 12;
            const double v = 200 + (dx * std::sin(angle) + dy * std::cos(angle)) / 12;
            const auto i = static_cast<std::size_t>(u);
            const auto j = static_cast<std::size_t>(v);
            const double a = u - static_cast<double>(i);
            const double b = v - static_cast<double>(j);
            const auto z = [&](std::size_t p, std::size_t q) {
                return static_cast<double>(noise[q * 400 + p]);
            };
            const double hills = (1 - b) * ((1 - a) * z(i, j) + a * z(i + 1, j)) +
                                 b * ((1 - a) * z(i, j + 1) + a * z(i + 1, j + 1));
            const double inside = std::max(0.0, 1 - r * r / 0.81);
            return 300 * inside + hills * inside * inside - 20 * r;
        };
    };
    std::array<double, 2> eroded{};
    for (int turned = 0; turned < 2; ++turned) {
        std::vector<double> change;
        eroded[turned] = eroded_after(under_cloudburst(grid, surface(turned * std::acos(-1.0) / 4)),
                                      rain_erosion({"time.tick_s=2"}), 240, &change);
        const std::array<double, 8> histogram = gully_directions(change, n);
        fmt::print("turned by {}: net eroded {:.4e} m3; gullies towards 0, 22.5 … 157.5 degrees:",
                   45 * turned, eroded[turned]);
        for (const double share : histogram) fmt::print(" {:.3f}", share);
        fmt::print("\n");
        for (const double share : histogram) EXPECT_NEAR(share, 0.125, 0.045);
    }
    fmt::print("turned by 45 degrees: net eroded {:+.2f} %\n", 100 * (eroded[1] / eroded[0] - 1));
    EXPECT_NEAR(eroded[1] / eroded[0], 1, 0.03);
}

}  // namespace
}  // namespace talus::erosion_test
