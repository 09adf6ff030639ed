#pragma once
#include <vector>

#include "sim/packed_bytes.h"
#include "sim/terrain/terrain.h"

namespace talus {

/// A whole terrain, packed: what undo keeps where an act puts another terrain in its place.
struct PackedTerrain {
    Grid grid;
    PackedBytes solid;
    PackedBytes start;
    PackedBytes earlier_start;          ///< without bytes: none
    std::vector<PackedBytes> optional;  ///< as layers(); without bytes: not there, or of the solid
    std::vector<float> bed_beyond;      ///< as Terrain
    std::array<bool, painted_number_count> ever_painted{};  ///< as Terrain
    std::size_t bytes() const;
};

/// Waits for the device.
PackedTerrain pack(const Terrain& terrain);
/// The terrain again, to the bit, with all tiles marked.
Terrain unpack(const PackedTerrain& packed);

}  // namespace talus
