#include "sim/terrain/state_hash.h"

#include <xxhash.h>

#include <array>

#include "sim/events.h"
#include "sim/terrain/layers.h"

namespace talus {

std::uint64_t state_hash(const TerrainState& state) {
    XXH3_state_t* hash = XXH3_createState();
    XXH3_64bits_reset(hash);
    const std::array<std::int64_t, 3> whole = {state.grid.nx, state.grid.ny, state.clock.ticks};
    const std::array<double, 3> real = {state.grid.dx, state.grid.dy, state.clock.simulated_s};
    XXH3_64bits_update(hash, whole.data(), sizeof(whole));
    XXH3_64bits_update(hash, real.data(), sizeof(real));
    for (const LayerDescription& layer : layers()) {
        const std::span<const float> words = words_of(state, layer);
        XXH3_64bits_update(hash, words.data(), words.size_bytes());
    }
    XXH3_64bits_update(hash, state.bed_beyond.data(), state.bed_beyond.size() * sizeof(float));
    XXH3_64bits_update(hash, state.springs.data(), state.springs.size() * sizeof(Spring));
    for (const Drive& drive : state.drives) {
        XXH3_64bits_update(hash, drive.parameter.data(), drive.parameter.size());
        const std::vector<TimeSeries::Row>& rows = drive.series.rows();
        XXH3_64bits_update(hash, rows.data(), rows.size() * sizeof(TimeSeries::Row));
    }
    if (!state.events.empty()) {
        const std::string events = to_text(state.events);
        XXH3_64bits_update(hash, events.data(), events.size());
    }
    if (state.edges_since_s != 0) XXH3_64bits_update(hash, &state.edges_since_s, sizeof(state.edges_since_s));
    const std::uint64_t value = XXH3_64bits_digest(hash);
    XXH3_freeState(hash);
    return value;
}

std::uint64_t bytes_hash(std::span<const std::byte> bytes) {
    return XXH3_64bits(bytes.data(), bytes.size());
}

}  // namespace talus
