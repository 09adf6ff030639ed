#include "sim/terrain/bed_beyond.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sim/error.h"
#include "sim/terrain/terrain.h"

namespace talus {
namespace {

using int2 = glm::ivec2;

// The maths' way round a map.
struct Edges {
    int2 samples;
#include "maths/edge_places.glsl"
};

constexpr int further_samples = water_ghosts;

}  // namespace

std::size_t words_of_bed_beyond(const Grid& grid) {
    return static_cast<std::size_t>(further_samples) * Edges{{grid.nx, grid.ny}}.edge_places();
}

std::vector<float> bed_beyond_of(const Grid& grid, const BedAt& bed_at) {
    Edges edges{{grid.nx, grid.ny}};
    std::vector<float> beds;
    beds.reserve(words_of_bed_beyond(grid));
    for (int index = 0; index < edges.edge_places(); ++index) {
        const Edges::EdgePlace place = edges.edge_place(index);
        for (int further = 1; further <= further_samples; ++further)
            beds.push_back(bed_at(place.at + further * place.outward));
    }
    return beds;
}

BedAt bed_around(const TerrainState& state) {
    const int2 samples(state.grid.nx, state.grid.ny);
    const int2 last = samples - 1;
    return [&state, samples, last, ground = state.ground()](int2 at) {
        const int2 inside = glm::clamp(at, int2(0), last);
        if (inside == at) return ground[static_cast<std::size_t>(at.y) * samples.x + at.x];
        const int2 off = at - inside;
        const int further = std::max(std::abs(off.x), std::abs(off.y));
        const bool beside_an_edge = off.x == 0 || off.y == 0;
        if (state.bed_beyond.empty() || !beside_an_edge || further > further_samples)
            return glsl::unknown_bed;
        const int first = off.y < 0   ? 0
                          : off.y > 0 ? samples.x
                          : off.x < 0 ? 2 * samples.x
                                      : 2 * samples.x + samples.y;
        const int index = first + (off.y != 0 ? at.x : at.y);
        return state.bed_beyond[static_cast<std::size_t>(further_samples * index + further - 1)];
    };
}

void check_bed_beyond(const TerrainState& state) {
    if (state.bed_beyond.empty()) return;
    const std::size_t expected = words_of_bed_beyond(state.grid);
    if (state.bed_beyond.size() != expected)
        throw Error(fmt::format(
            "{} heights of the ground beyond the edges are not as many as {} x {} samples have, {}",
            state.bed_beyond.size(), state.grid.nx, state.grid.ny, expected));
    if (!std::all_of(state.bed_beyond.begin(), state.bed_beyond.end(),
                     [](float bed) { return std::isfinite(bed); }))
        throw Error("heights of the ground beyond the edges must be finite numbers");
}

}  // namespace talus
