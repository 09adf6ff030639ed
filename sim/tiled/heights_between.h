#pragma once
#include <functional>
#include <optional>
#include <vector>

#include "sim/tiled/tile_bounds.h"

namespace talus {

/// Between which heights a ground lies from one column and row to another (a part of a patch counts as all of
/// it), lowest and highest, or a little beyond. None: no ground lies there.
using HeightsBetween = std::function<std::optional<glm::vec2>(glm::dvec2 first, glm::dvec2 last)>;

/// Of a ground that is held as a whole.
HeightsBetween heights_between(const Grid& grid, std::vector<float> heights);

/// Of one in tiles, by what is known of them.
HeightsBetween heights_between(const TileTree& tree, std::vector<TileBounds> bounds);

}  // namespace talus
