#pragma once
#include <future>
#include <map>
#include <memory>
#include <vector>

#include "sim/gpu/readback.h"
#include "sim/packed_bytes.h"
#include "sim/terrain/terrain.h"

namespace talus {

/// A tile as it was, on the device: its solid and, behind it, each optional layer whose bit is set.
struct KeptTile {
    gpu::Buffer texels;
    unsigned layers = 0;
};

/// The tile as it is now, copied on the device.
KeptTile copy_tile(Terrain& terrain, int tile);

/// What an act changed in tiles: for every word, the bits in which before and after differ. The same bits
/// lead back and forth. They are read from the device without waiting, and packed on a thread of their own.
class TileChanges {
  public:
    TileChanges() = default;
    /// From the tiles as they were to the terrain as it is. `before` is let go.
    TileChanges(Terrain& terrain, std::map<int, KeptTile>& before);

    /// Moves reading and packing on without waiting.
    void poll();
    /// Waits until all is packed.
    void settle();
    bool is_settled() const;

    /// Leads the terrain from after to before, or from before to after. Waits for the device.
    void apply(Terrain& terrain);

    bool empty() const { return chunks_.empty(); }
    /// Memory that it takes now: packed, or still as it came.
    std::size_t bytes() const;

  private:
    // So many tiles are read and packed together.
    struct Chunk {
        std::vector<int> tiles;
        unsigned layers = 0;  // of after, and so of both
        std::size_t raw_bytes = 0;
        gpu::Readback before_and_after;
        std::future<PackedBytes> packing;
        PackedBytes packed;
    };
    static void pack(Chunk& chunk, const std::vector<float>& words);
    std::vector<std::unique_ptr<Chunk>> chunks_;
};

}  // namespace talus
