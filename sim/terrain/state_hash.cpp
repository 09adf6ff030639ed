#include "sim/terrain/state_hash.h"

#include <xxhash.h>

#include <array>

namespace talus {

std::uint64_t state_hash(const TerrainState& state) {
    XXH3_state_t* hash = XXH3_createState();
    XXH3_64bits_reset(hash);
    const std::array<std::int64_t, 3> whole = {state.grid.nx, state.grid.ny, state.clock.ticks};
    const std::array<double, 3> real = {state.grid.dx, state.grid.dy, state.clock.simulated_s};
    XXH3_64bits_update(hash, whole.data(), sizeof(whole));
    XXH3_64bits_update(hash, real.data(), sizeof(real));
    XXH3_64bits_update(hash, state.bedrock.data(), state.bedrock.size() * sizeof(glm::vec2));
    XXH3_64bits_update(hash, state.regolith.data(), state.regolith.size() * sizeof(glm::vec2));
    XXH3_64bits_update(hash, state.water.data(), state.water.size() * sizeof(glm::vec4));
    XXH3_64bits_update(hash, state.inundation.data(), state.inundation.size() * sizeof(glm::vec2));
    XXH3_64bits_update(hash, state.suspended.data(), state.suspended.size() * sizeof(glm::vec2));
    XXH3_64bits_update(hash, state.painted.data(), state.painted.size() * sizeof(glm::vec4));
    XXH3_64bits_update(hash, state.springs.data(), state.springs.size() * sizeof(Spring));
    if (state.edges_since_s != 0) XXH3_64bits_update(hash, &state.edges_since_s, sizeof(state.edges_since_s));
    const std::uint64_t value = XXH3_64bits_digest(hash);
    XXH3_freeState(hash);
    return value;
}

std::uint64_t bytes_hash(std::span<const std::byte> bytes) {
    return XXH3_64bits(bytes.data(), bytes.size());
}

}  // namespace talus
