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

/// The XOR delta of the tiles that an act changed: each 32-bit word before the act XOR the word after it. The
/// same delta undoes and redoes the act. The read-back does not wait; a background task packs the delta.
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

    /// Undoes the act, or redoes it, by XOR of the delta into the tiles. Waits for the device.
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
