// Terrains of another shape: what is exact stays exact, and the coordinates of every place on Earth stay
// where they were.
#include <gtest/gtest.h>

#include <cmath>

#include "sim/error.h"
#include "sim/terrain/bed_beyond.h"
#include "sim/terrain/generate.h"
#include "sim/terrain/reshape.h"
#include "sim/terrain/state_hash.h"

namespace talus::reshape_test {
namespace {

float bed_off_the_map(glm::ivec2 at) {
    return static_cast<float>(1000 + 100 * at.x + at.y);
}

// All layers, and what lies on them.
TerrainState wet_hills(const Grid& grid) {
    TerrainState state = bedrock_terrain(grid, generate_heights(grid, {"hills", 9, 400}));
    for (std::size_t i = 0; i < grid.count(); ++i) {
        const auto t = static_cast<float>(i % 97) / 97;
        state.regolith[i] = {t, 1e-9F * t};
        state.water.emplace_back(2 * t, 0, 0.5F * t, -t);
        state.inundation.emplace_back(3 * t, 10 * t);
        state.suspended.emplace_back(0.1F * t, 0);
        state.painted.emplace_back(t, 1 - t, 40 * t, 0);
    }
    state.bed_beyond =
        bed_beyond_of(grid, [](glm::ivec2 at) { return at.y < 0 ? glsl::unknown_bed : bed_off_the_map(at); });
    state.springs = {{100, 50, 3}, {20, 200, 4}};
    state.georeference = Georeference{"", {500000, 30, 2, 4000000, 1, -20}};
    return state;
}

// Coordinates of a sample.
glm::dvec2 place(const TerrainState& state, double column, double row) {
    const auto& t = state.georeference->transform;
    return {t[0] + t[1] * (column + 0.5) + t[2] * (row + 0.5),
            t[3] + t[4] * (column + 0.5) + t[5] * (row + 0.5)};
}

TEST(Reshape, FourQuartersAreNoneAndACropOfAllIsAll) {
    const TerrainState state = wet_hills({23, 17, 30, 20});
    const std::uint64_t hash = state_hash(state);
    EXPECT_EQ(state_hash(turned(turned(state, 3), 1)), hash);
    EXPECT_FALSE(turned(state, 2).georeference);
    EXPECT_EQ(state_hash(cropped(state, {0, 0, 22.0 * 30, 16.0 * 20})), hash);
    EXPECT_EQ(state_hash(resampled(state, 23, 17)), hash);
    EXPECT_NE(state_hash(turned(state, 2)), hash);
}

TEST(Reshape, AQuarterTurnsPlacesCurrentsAndSprings) {
    const TerrainState state = wet_hills({23, 17, 30, 20});
    const TerrainState next = turned(state, 1);
    ASSERT_EQ(next.grid.nx, 17);
    ASSERT_EQ(next.grid.dx, 20);
    // The north-east sample is the north-west one now.
    EXPECT_EQ(next.bedrock[0], state.bedrock[22]);
    const glm::vec4 before = state.water[22];
    EXPECT_EQ(next.water[0], glm::vec4(before.x, before.y, -before.w, before.z));
    // A spring stands on the sample that it stood on.
    const auto ground_at = [](const TerrainState& s, const Spring& spring) {
        const auto column = static_cast<std::size_t>(std::lround(s.grid.column_of(spring.x_m)));
        const auto row = static_cast<std::size_t>(std::lround(s.grid.row_of(spring.y_m)));
        return s.bedrock[row * static_cast<std::size_t>(s.grid.nx) + column];
    };
    for (std::size_t i = 0; i < 2; ++i)
        EXPECT_EQ(ground_at(next, next.springs[i]), ground_at(state, state.springs[i]));
}

TEST(Reshape, ACropKeepsBitsAndPlaces) {
    const TerrainState state = wet_hills({23, 17, 30, 20});
    const TerrainState next = cropped(state, {95, 45, 305, 155});
    // Outwards to whole samples: 90 to 330 m, 40 to 160 m.
    ASSERT_EQ(next.grid.nx, 9);
    ASSERT_EQ(next.grid.ny, 7);
    EXPECT_EQ(next.bedrock[0], state.bedrock[8 * 23 + 3]);
    EXPECT_EQ(next.painted[6 * 9 + 8], state.painted[14 * 23 + 11]);
    EXPECT_EQ(place(next, 2, 3), place(state, 5, 11));
    ASSERT_EQ(next.springs.size(), 1U);
    EXPECT_DOUBLE_EQ(next.springs[0].x_m, 10);
    EXPECT_DOUBLE_EQ(next.springs[0].y_m, 10);
    EXPECT_THROW(cropped(state, {-100, -100, -20, -20}), Error);
    EXPECT_THROW(cropped(state, {300, 0, 100, 300}), Error);
}

// What is cut off, and what lay beyond: heights that tell where each of them came from.
TEST(Reshape, TheGroundBeyondTheEdgesGoesAlong) {
    const TerrainState state = wet_hills({23, 17, 30, 20});
    const std::vector<float> ground = state.ground();
    const auto old_bed = [&](glm::ivec2 at) {
        if (at.y < 0) return glsl::unknown_bed;
        const bool inside = at.x >= 0 && at.x < 23 && at.y < 17;
        return inside ? ground[static_cast<std::size_t>(at.y) * 23 + at.x] : bed_off_the_map(at);
    };
    // One row short in the north, none in the south, two columns short in the east, many in the west.
    const TerrainState part = cropped(state, {10.0 * 30, 0, 20.0 * 30, 15.0 * 20});
    ASSERT_EQ(part.grid, (Grid{11, 16, 30, 20}));
    EXPECT_EQ(part.bed_beyond,
              bed_beyond_of(part.grid, [&](glm::ivec2 at) { return old_bed(at + glm::ivec2(10, 1)); }));
    EXPECT_EQ(part.bed_beyond[0], ground[10]);
    EXPECT_EQ(part.bed_beyond[1], glsl::unknown_bed);
    // A quarter: what lay in the north lies in the west.
    const TerrainState next = turned(state, 1);
    EXPECT_EQ(next.bed_beyond, bed_beyond_of(next.grid, [&](glm::ivec2 at) {
                  return old_bed({22 - at.y, at.x});
              }));
    EXPECT_TRUE(resampled(state, 40, 40).bed_beyond.empty());
    // Nothing is known of what has nothing around it.
    TerrainState alone = state;
    alone.bed_beyond.clear();
    EXPECT_TRUE(cropped(alone, {300, 0, 600, 300}).bed_beyond.empty());
    EXPECT_TRUE(turned(alone, 1).bed_beyond.empty());
}

TEST(Reshape, ResamplingKeepsSlopesConstantsAndPlaces) {
    const Grid grid{41, 33, 10, 15};
    TerrainState state = bedrock_terrain(grid, std::vector<float>(grid.count()));
    for (int y = 0; y < grid.ny; ++y)
        for (int x = 0; x < grid.nx; ++x)
            state.bedrock[static_cast<std::size_t>(y) * grid.nx + x] = {4000.0F + 2.0F * x - 3.0F * y, 0};
    state.regolith.assign(grid.count(), {1.5F, 0});
    state.georeference = Georeference{"", {1000, 10, 0, 2000, 0, -15}};
    for (const glm::ivec2 size : {glm::ivec2(81, 65), glm::ivec2(60, 50), glm::ivec2(21, 17)}) {
        const TerrainState next = resampled(state, size.x, size.y);
        EXPECT_DOUBLE_EQ(next.grid.width_m(), grid.width_m());
        EXPECT_DOUBLE_EQ(next.grid.height_m(), grid.height_m());
        double worst = 0;
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x) {
                const std::size_t i = static_cast<std::size_t>(y) * size.x + x;
                EXPECT_EQ(next.regolith[i], glm::vec2(1.5F, 0));
                const double column = x * 40.0 / (size.x - 1);
                const double row = y * 32.0 / (size.y - 1);
                // Kernels that reach beyond the edge find the edge's height there.
                if (column < 4 || column > 36 || row < 4 || row > 28) continue;
                const double height = static_cast<double>(next.bedrock[i].x) + next.bedrock[i].y;
                worst = std::max(worst, std::abs(height - (4000 + 2 * column - 3 * row)));
            }
        EXPECT_LT(worst, 1e-9);
        const glm::dvec2 corner = place(next, size.x - 1, size.y - 1);
        EXPECT_NEAR(corner.x, place(state, 40, 32).x, 1e-9);
        EXPECT_NEAR(corner.y, place(state, 40, 32).y, 1e-9);
    }
}

TEST(Reshape, HalvingAndDoublingLoseOnlyDetail) {
    const Grid grid{129, 129, 10, 10};
    const TerrainState state = wet_hills(grid);
    const TerrainState again = resampled(resampled(state, 257, 257), 129, 129);
    double square = 0;
    double water = 0;
    double water_before = 0;
    for (std::size_t i = 0; i < grid.count(); ++i) {
        const double difference = static_cast<double>(again.bedrock[i].x) - state.bedrock[i].x;
        square += difference * difference;
        water += again.water[i].x;
        water_before += state.water[i].x;
        EXPECT_GE(again.water[i].x, 0);
        EXPECT_GE(again.regolith[i].x, 0);
    }
    EXPECT_LT(std::sqrt(square / static_cast<double>(grid.count())), 1) << "of 400 m";
    EXPECT_NEAR(water / water_before, 1, 0.02);
}

}  // namespace
}  // namespace talus::reshape_test
