#pragma once
#include <cstdint>
#include <vector>

#include "sim/gpu/buffer.h"
#include "sim/gpu/program.h"
#include "sim/gpu/texture.h"
#include "sim/terrain/grid.h"

namespace talus {

/// A list of tiles on the device, made there: the arguments of an indirect dispatch, then the tiles' indices.
struct TileList {
    explicit TileList(int tile_count);
    gpu::Buffer buffer;
};

/// The one set of changed tiles. Whatever writes samples marks their tile for all readers at once; each
/// reader lists and clears its own mark, so that work follows what changed and nothing is read back.
class Tiles {
  public:
    enum Mark : std::uint32_t {
        surface = 1,
        activity = 2,
        undo = 4,
        sky = 8,
        bed = 16,            ///< ground or water was changed by others than the water's own sub-steps
        wet = 32,            ///< its water is active; 128 to 1024 say beside which neighbours (water.comp)
        water_surface = 64,  ///< its water changed since it was last drawn
        wet_sides = 128 | 256 | 512 | 1024,
        inundation = 2048  ///< its water changed since the inundation map was last brought up to it
    };

    explicit Tiles(const Grid& grid);

    int columns() const { return columns_; }
    int rows() const { return rows_; }
    int count() const { return columns_ * rows_; }
    /// The samples of a tile, cut at the terrain's edge.
    gpu::Region region(int tile) const;
    /// The tiles that a rectangle of samples touches, cut at the terrain's edge; empty when it lies outside.
    std::vector<int> touched_by(const gpu::Region& samples) const;

    /// Binds the flags for a pass that may mark tiles.
    void bind_for_marking() {
        ++changes_;
        flags_.bind_storage(0);
    }
    /// Rises with everything that may have marked a tile: while it stays, no tile changes.
    std::uint64_t changes() const { return changes_; }
    void mark_all() {
        ++changes_;
        flags_.fill(surface | activity | undo | sky | bed | wet | water_surface | wet_sides | inundation);
    }
    /// Lists the tiles that carry the mark, or have a neighbour at an offset from reach_low to reach_high
    /// that does, then clears the mark everywhere. The list's dispatch is groups_per_tile x tiles x 1.
    void take(Mark mark, int reach_low, int reach_high, int groups_per_tile, TileList& list);
    void clear(Mark mark);
    /// A word of marks a tile, on the device.
    const gpu::Buffer& marks() const { return flags_; }
    /// Which tiles carry the mark. Waits for the device.
    std::vector<bool> read(Mark mark) const;

  private:
    Grid grid_;
    int columns_;
    int rows_;
    gpu::Buffer flags_;
    std::uint64_t changes_ = 0;
    gpu::Program list_program_;
    gpu::Program clear_program_;
};

}  // namespace talus
