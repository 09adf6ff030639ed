#pragma once
#include <cstddef>
#include <cstdint>
#include <span>

#include "sim/terrain/terrain.h"

namespace talus {

/// A hash (XXH3) of all bits of a state: grid, layers with their low words, clock.
std::uint64_t state_hash(const TerrainState& state);

/// The same hash of any bytes.
std::uint64_t bytes_hash(std::span<const std::byte> bytes);

}  // namespace talus
