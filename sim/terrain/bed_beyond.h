#pragma once
#include <functional>
#include <vector>

#include "sim/terrain/terrain_state.h"

namespace talus {

namespace glsl {
#include "maths/bed_beyond.glsl"
}

/// A terrain that is a part of a larger one knows the ground beyond its edges, as far as the water's scheme
/// sees it: two samples outwards of each sample of the edges, the nearer one first, edge samples in the order
/// of maths/edge_places.glsl. Open, level and wave edges take it (docs/numerics.md, "Edges of the water").
/// glsl::unknown_bed stands where the larger terrain ends too.
std::size_t words_of_bed_beyond(const Grid& grid);

/// Height of the ground, m, or glsl::unknown_bed, at a column and row that may lie off the map.
using BedAt = std::function<float(glm::ivec2)>;

/// What TerrainState::bed_beyond holds of a map of this size.
std::vector<float> bed_beyond_of(const Grid& grid, const BedAt& bed_at);

/// The ground of a state, and beyond it what it knows. The state must outlive it.
BedAt bed_around(const TerrainState& state);

/// Throws talus::Error where a state's heights beyond the edges are more or fewer than its size has, or one
/// is not finite.
void check_bed_beyond(const TerrainState& state);

}  // namespace talus
