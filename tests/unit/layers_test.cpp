// What holds for every layer of the table, whatever it is for: nothing that loops over layers leaves one out.
#include <gtest/gtest.h>

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "sim/error.h"
#include "sim/gpu/context.h"
#include "sim/io/document.h"
#include "sim/packed_terrain.h"
#include "sim/terrain/bed_beyond.h"
#include "sim/terrain/layers.h"
#include "sim/terrain/reshape.h"
#include "sim/terrain/state_hash.h"
#include "sim/terrain/state_readback.h"
#include "sim/terrain/terrain.h"

namespace talus::layers_test {
namespace {

// Every number of every layer has a value of its own in every sample, and one that files may hold.
TerrainState full_state() {
    const Grid grid{37, 29, 3, 4};
    TerrainState state = bedrock_terrain(grid, std::vector<float>(grid.count(), 100.0F));
    int salt = 0;
    for (const LayerDescription& layer : layers()) {
        make_layer(state, layer, grid.count());
        const std::span<float> words = words_of(state, layer);
        std::size_t word = 0;
        for (const LayerNumber& number : layer.numbers) {
            ++salt;
            for (std::size_t i = 0; i < grid.count(); ++i) {
                float* at = &words[i * static_cast<std::size_t>(layer.words()) + word];
                at[0] = static_cast<float>((i * 7 + static_cast<std::size_t>(salt) * 13) % 101 + 1) / 128;
                if (number.two_words) at[1] = at[0] * 1e-8F;
            }
            word += number.two_words ? 2 : 1;
        }
    }
    state.bed_beyond = bed_beyond_of(grid, [](glm::ivec2 at) { return static_cast<float>(7 * at.x + at.y); });
    return state;
}

void expect_same_layers(const TerrainState& one, const TerrainState& other) {
    EXPECT_EQ(one.bed_beyond, other.bed_beyond);
    for (const LayerDescription& layer : layers()) {
        const auto a = words_of(one, layer);
        const auto b = words_of(other, layer);
        EXPECT_TRUE(std::equal(a.begin(), a.end(), b.begin(), b.end())) << layer.name;
    }
}

TEST(Layers, ComeBackFromTheDeviceFromPackingAndFromTheDocument) {
    const gpu::Context context;
    const TerrainState state = full_state();
    const Terrain terrain(state);
    expect_same_layers(terrain.read(), state);
    expect_same_layers(unpack(pack(terrain)).read(), state);
    StateReadback readback;
    readback.start(terrain);
    std::optional<TerrainState> read;
    while (!read) read = readback.poll();
    expect_same_layers(*read, state);
    const std::filesystem::path path =
        std::filesystem::temp_directory_path() / ("talus_layers_" + std::to_string(::getpid()) + ".exr");
    io::save_document(path, {state, "", "", {}});
    expect_same_layers(io::open_document(path, {}).state, state);
    std::filesystem::remove(path);
}

TEST(Layers, AreInTheHashAndAmongTheOutputs) {
    const TerrainState state = full_state();
    const std::vector<std::string> names = output_names();
    for (const LayerDescription& layer : layers()) {
        TerrainState changed = state;
        words_of(changed, layer).back() += 1;
        EXPECT_NE(state_hash(changed), state_hash(state)) << layer.name;
        std::size_t word = 0;
        for (const LayerNumber& number : layer.numbers) {
            ASSERT_NE(std::find(names.begin(), names.end(), number.name), names.end()) << number.name;
            EXPECT_EQ(output_of(state, number.name)[40],
                      words_of(state, layer)[40 * static_cast<std::size_t>(layer.words()) + word]);
            word += number.two_words ? 2 : 1;
        }
    }
    TerrainState changed = state;
    changed.bed_beyond.back() += 1;
    EXPECT_NE(state_hash(changed), state_hash(state));
    EXPECT_THROW(output_of(state, "lava"), Error);
    EXPECT_EQ(output_of(state, "depth"), output_of(state, "water"));
    EXPECT_EQ(output_unit("depth"), "m");
    // What a difference counts from is no part of the run.
    changed = state;
    changed.start = state.ground_words();
    EXPECT_EQ(output_of(changed, "difference"), std::vector<float>(state.grid.count(), 0.0F));
    changed.start[40].x -= 2;
    EXPECT_EQ(output_of(changed, "difference")[40], 2);
    EXPECT_EQ(state_hash(changed), state_hash(state));
}

TEST(Layers, FollowCropsAndTurns) {
    const TerrainState state = full_state();
    expect_same_layers(turned(turned(state, 1), 3), state);
    const TerrainState half_turned = turned(state, 2);
    const TerrainState piece = cropped(state, {6, 8, 60, 80});
    const TerrainState coarse = resampled(state, 19, 15);
    for (const LayerDescription& layer : layers()) {
        const auto size = static_cast<std::size_t>(layer.words());
        // The first sample of all is the last one now; currents run the other way.
        for (std::size_t word = 0; word < size; ++word)
            EXPECT_EQ(std::abs(words_of(half_turned, layer)[(state.grid.count() - 1) * size + word]),
                      words_of(state, layer)[word])
                << layer.name;
        // The crop begins at column 2 of row 28 - 20.
        EXPECT_EQ(words_of(piece, layer)[0], words_of(state, layer)[(8 * 37 + 2) * size]) << layer.name;
        EXPECT_EQ(words_of(coarse, layer).size(), coarse.grid.count() * size) << layer.name;
    }
}

}  // namespace
}  // namespace talus::layers_test
