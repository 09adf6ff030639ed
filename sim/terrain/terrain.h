#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <vector>

#include "sim/gpu/program.h"
#include "sim/gpu/texture.h"
#include "sim/terrain/grid.h"
#include "sim/terrain/tiles.h"
#include "sim/terrain/water_layer.h"

namespace talus {

/// Simulated time since the start.
struct Clock {
    std::int64_t ticks = 0;
    double simulated_s = 0;
    bool operator==(const Clock&) const = default;
};

/// Water that comes out of the ground at a place.
struct Spring {
    double x_m = 0;
    double y_m = 0;
    double rate_m3_per_s = 0;
    bool operator==(const Spring&) const = default;
};

/// Everything that a run continues from, in main memory: rows of samples, row 0 north, heights in metres as
/// two words (high, low). What the document stores.
struct TerrainState {
    Grid grid;
    std::vector<glm::vec2> bedrock;
    std::vector<glm::vec2> regolith;
    /// Depth, m, two words, and discharge east and north, m²/s; empty: no water was ever here.
    std::vector<glm::vec4> water;
    std::vector<Spring> springs;
    /// The simulated time from which inflow and wave maker count: when they were last set.
    double edges_since_s = 0;
    Clock clock;

    /// Ground = bedrock + regolith, rounded to one float a sample.
    std::vector<float> ground() const;
};

/// A terrain of one layer of bedrock. Throws talus::Error when the grid cannot be used.
TerrainState bedrock_terrain(const Grid& grid, const std::vector<float>& heights_m);

/// A layer on the device: passes read `front` and write `back`. Both hold the same bits in tiles at rest.
struct Layer {
    gpu::Texture front;
    gpu::Texture back;
};

/// The layers on the device, the ground that follows them, and the set of changed tiles.
class Terrain {
  public:
    explicit Terrain(const TerrainState& state);

    const Grid& grid() const { return grid_; }
    Layer solid;          ///< m: bedrock and regolith, two words each, in one texel (docs/benchmarks.md)
    gpu::Texture ground;  ///< m, one float: what the eye sees; every pass that writes layers writes it too
    gpu::Texture start;   ///< m, two words: the ground when the terrain was made, for the ledger
    Tiles tiles;
    std::optional<WaterLayer> water;  ///< none: no water was ever here

    /// Binds layers, ground and flags as shaders/sim/samples.glsl expects them, and sets its uniforms.
    void bind(gpu::Program& program);
    /// The back images become the front ones.
    void swap();
    /// After back was written in these samples outside of a swap: front gets the same bits.
    void settle(const gpu::Region& samples);
    /// After layers were written from outside in these samples: front and back hold them, ground follows.
    void refresh(const gpu::Region& samples);

    /// From now on there is a water layer, dry where it was none.
    void add_water();
    /// Puts these samples, rows of depth (two words) and discharge, in place of the water there.
    void write_water(const gpu::Region& samples, std::span<const glm::vec4> water);

    /// Reads the layers back. Waits for the device. The clock is left at 0.
    TerrainState read() const;

  private:
    Grid grid_;
    gpu::Program ground_program_;
};

}  // namespace talus
