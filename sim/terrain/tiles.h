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

namespace tile_changes {
using uint = std::uint32_t;
#include "sim/tile_changes.glsl"
}  // namespace tile_changes

/// The one set of changed tiles. A writer stamps a tile with a running number for each kind of change. A
/// reader remembers how far it has read, and lists the tiles with later stamps. So work follows what changed,
/// nothing is read back, and any number of readers see everything.
class Tiles {
  public:
    /// Kinds of change, as bits that readers combine.
    enum Change : std::uint32_t {
        ground = 1U << tile_changes::tile_ground,  ///< by anything but the water's own sub-steps
        eroded = 1U << tile_changes::tile_eroded,  ///< the ground, by those
        water = 1U << tile_changes::tile_water,    ///< by its sub-steps
        placed = 1U << tile_changes::tile_placed,  ///< the water, by others
        load = 1U << tile_changes::tile_load,      ///< what the water carries
        painted = 1U << tile_changes::tile_painted,
        inundation = 1U << tile_changes::tile_inundation,
        anything = (1U << tile_changes::tile_kinds) - 1
    };
    /// How far one reader has read: nothing yet. Of another terrain's tiles it has read nothing, either.
    struct Reader {
        std::uint32_t round = 0;
        std::uint32_t read = 0;
        bool operator==(const Reader&) const = default;
    };

    /// After `last_number` a new round of numbers begins, and everything counts as changed for every reader.
    explicit Tiles(const Grid& grid, std::uint32_t last_number = 0xffffffff);

    int columns() const { return columns_; }
    int rows() const { return rows_; }
    int count() const { return columns_ * rows_; }
    /// The samples of a tile, cut at the terrain's edge.
    gpu::Region region(int tile) const;
    /// The tiles that a rectangle of samples touches, cut at the terrain's edge; empty when it lies outside.
    std::vector<int> touched_by(const gpu::Region& samples) const;

    /// Before each dispatch of a program that may stamp tiles (shaders/sim/tile_stamps.glsl): binds the
    /// stamps, and gives it the next number.
    void bind_for_stamping(gpu::Program& program);
    /// Rises with everything that may stamp a tile: while it stays, no tile changes.
    std::uint64_t now() const { return std::uint64_t{round_} << 32U | now_; }
    /// A reader that has read everything until now.
    Reader reader_now() const { return {round_, now_}; }
    /// Everything counts as changed.
    void mark_all();
    /// Lists the tiles that changed since the reader read last, or have a neighbour at an offset from
    /// reach_low to reach_high that did. The list's dispatch is groups_per_tile x tiles x 1.
    void list(std::uint32_t changes, Reader& reader, int reach_low, int reach_high, int groups_per_tile,
              TileList& list) const;
    /// Which tiles changed since the reader read last. Waits for the device.
    std::vector<bool> read(std::uint32_t changes, const Reader& reader) const;
    /// Whether one tile did, by its stamps, which were read back.
    bool has_changed(std::uint32_t changes, const Reader& reader, const std::uint32_t* stamps_of_tile) const;
    /// A number for each kind of change, tile after tile, on the device.
    const gpu::Buffer& stamps() const { return stamps_; }

  private:
    std::uint32_t next();
    // What a reader has not read yet has later stamps. Of a new round it has read nothing.
    std::uint32_t since(const Reader& reader) const { return reader.round == round_ ? reader.read : 0; }

    Grid grid_;
    int columns_;
    int rows_;
    gpu::Buffer stamps_;
    std::uint32_t last_number_;
    std::uint32_t round_;  // no two of a program are the same
    std::uint32_t now_ = 0;
    mutable gpu::Program list_program_;
};

}  // namespace talus
