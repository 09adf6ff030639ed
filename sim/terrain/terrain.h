#pragma once
#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <vector>

#include "sim/gpu/program.h"
#include "sim/gpu/texture.h"
#include "sim/terrain/georeference.h"
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
    /// Largest depth so far, m, and the simulated time at which water arrived, s; empty: none ever did.
    std::vector<glm::vec2> inundation;
    /// Solid in the water above a sample, m, two words; empty: none.
    std::vector<glm::vec2> suspended;
    /// What brushes painted, as PaintedLayer says; empty: nothing.
    std::vector<glm::vec4> painted;
    std::vector<Spring> springs;
    /// The simulated time from which inflow and wave maker count: when they were last set.
    double edges_since_s = 0;
    Clock clock;
    std::optional<Georeference> georeference;

    /// Ground = bedrock + regolith, rounded to one float a sample.
    std::vector<float> ground() const;
};

/// An optional layer that is zero throughout is none.
void drop_zero_layers(TerrainState& state);

/// A terrain of one layer of bedrock. Throws talus::Error when the grid cannot be used.
TerrainState bedrock_terrain(const Grid& grid, const std::vector<float>& heights_m);

/// Components of the painted layer: hardness and mask, 0 to 1, and rain, mm/h.
enum class PaintedLayer { hardness = 0, mask = 1, rain = 2 };

/// A layer on the device: passes read `front` and write `back`. Both hold the same bits in tiles at rest.
struct Layer {
    gpu::Texture front;
    gpu::Texture back;
};

/// A layer that is there once something needs it, and zero before: its image, if it is there, and the ghost
/// samples around it.
struct OptionalLayer {
    gpu::Texture* front = nullptr;
    gpu::Format format = gpu::Format::rgba32f;
    int ghosts = 0;

    gpu::Region texels(const gpu::Region& samples) const {
        return {samples.x + ghosts, samples.y + ghosts, samples.width, samples.height};
    }
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
    std::optional<WaterLayer> water;         ///< none: no water was ever here
    std::optional<gpu::Texture> inundation;  ///< largest depth so far, m, arrival time, s; none: no water was
    /// Solid in the water, m, two words, texels as the water's; none: nothing was ever eroded by water.
    std::optional<Layer> suspended;
    std::optional<gpu::Texture> painted;  ///< as PaintedLayer says; none: nothing was painted

    /// Binds layers, ground and flags as shaders/sim/samples.glsl expects them, and sets its uniforms.
    void bind(gpu::Program& program);
    /// The back images become the front ones.
    void swap();
    /// After back was written in these samples outside of a swap: front gets the same bits.
    void settle(const gpu::Region& samples);
    /// After layers were written from outside in these samples: front and back hold them, ground follows.
    void refresh(const gpu::Region& samples);

    /// From now on there is a water layer and its inundation map, dry where it was none.
    void add_water();
    /// From now on there is a suspended layer, and water; zero where it was none.
    void add_suspended();
    /// From now on there is a painted layer, zero where it was none.
    void add_painted();
    /// All layers beside the solid, in an order that stays: what undo keeps.
    std::array<OptionalLayer, 4> optional_layers();
    /// Puts bedrock and regolith of a state of this size in place of those that are there.
    void write_solid(const TerrainState& state);
    /// Puts what was painted in place of what is there; empty: nothing is painted, and nothing changes.
    void write_painted(std::span<const glm::vec4> painted);
    /// Puts these samples, rows of depth (two words) and discharge, in place of the water there.
    void write_water(const gpu::Region& samples, std::span<const glm::vec4> water);

    /// Reads the layers back. Waits for the device. The clock is left at 0.
    TerrainState read() const;

  private:
    Grid grid_;
    gpu::Program ground_program_;
};

}  // namespace talus
