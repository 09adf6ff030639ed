#pragma once
#include <array>
#include <optional>

#include "sim/gpu/program.h"
#include "sim/gpu/texture.h"
#include "sim/terrain/painted_numbers.h"
#include "sim/terrain/terrain_state.h"
#include "sim/terrain/tiles.h"

namespace talus {

/// A layer on the device: passes read `front` and write `back`. Both hold the same bits in tiles at rest.
struct Layer {
    gpu::Texture front;
    gpu::Texture back;
};

namespace glsl {
#include "sim/water_layout.glsl"
}

/// Samples around the water, its bed and its load, beyond the map's edges.
constexpr int water_ghosts = glsl::water_ghosts;

/// A layer that is there once something needs it; it is 0 before. As LayerDescription says, it has a back
/// image, and ghost samples around.
struct DeviceLayer {
    gpu::Texture front;
    gpu::Texture back;
    int ghosts = 0;

    /// The texels of these samples.
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
    /// The same of TerrainState::start; none: that is `start`.
    std::optional<gpu::Texture> earlier_start;
    /// What a difference counts from.
    const gpu::Texture& difference_start() const { return earlier_start ? *earlier_start : start; }
    Tiles tiles;
    // Front images hold what TerrainState says.
    /// Back: of a sub-step's first stage; front's water wherever tiles rest. None: no water was ever here.
    std::optional<DeviceLayer> water;
    std::optional<DeviceLayer> inundation;  ///< with the water
    std::optional<DeviceLayer> suspended;   ///< none: nothing was ever eroded by water
    std::optional<DeviceLayer> painted;     ///< none: nothing was painted
    std::optional<DeviceLayer> land_cover;  ///< none: roughness and infiltration are the parameters'
    std::optional<DeviceLayer> flow;        ///< none: no water flowed, or it is not counted
    std::optional<DeviceLayer>
        worn_by_water;  ///< none: it wore nothing, or it is not counted; as those below
    std::optional<DeviceLayer> worn_by_slopes;
    std::optional<DeviceLayer> worn_by_hand;
    std::vector<float> bed_beyond;  ///< as in TerrainState; nothing changes it
    /// Of each PaintedNumber: it was painted somewhere, though that may be undone.
    std::array<bool, painted_number_count> ever_painted{};
    bool was_painted(PaintedNumber number) const { return ever_painted[static_cast<std::size_t>(number)]; }
    /// m: the ground under the water, as the last tick found it; texels as the water's, and there with it.
    gpu::Texture water_bed;

    /// Binds layers, ground and stamps as shaders/sim/samples.glsl expects them, and sets its uniforms.
    void bind(gpu::Program& program);
    /// The back images become the front ones.
    void swap();
    /// After back was written in these samples outside of a swap: front gets the same bits.
    void settle(const gpu::Region& samples);
    /// After layers were written from outside in these samples: front and back hold them, ground follows.
    void refresh(const gpu::Region& samples);

    /// From now on there is this layer, and what it needs; 0 where it was none.
    void add(std::optional<DeviceLayer> Terrain::*layer);
    /// Puts a state's bedrock and regolith, or another layer, in place of what is there. The state must have
    /// this terrain's size. A layer that the state has not stays as it is.
    void write_solid(const TerrainState& state);
    void write(std::optional<DeviceLayer> Terrain::*layer, const TerrainState& state);

    /// Reads the layers back, and what a difference counts from. Waits for the device. The clock is left at
    /// 0.
    TerrainState read() const;
    /// Reads one of the optional layers into a state of this size; nothing where it is not there.
    void read(const LayerDescription& layer, TerrainState& state) const;

  private:
    Grid grid_;
    gpu::Program ground_program_;
};

}  // namespace talus
