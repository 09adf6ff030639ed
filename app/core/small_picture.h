#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "sim/terrain/grid.h"

namespace talus::app {

/// The size of a small picture of a map in a dialog, pixels: as the map is shaped.
glm::ivec2 small_picture_size(const Grid& grid);

/// A small picture of heights (m, row 0 north) from above, lit from the north-west, RGBA. Where water is
/// deeper (m; empty: there is none) it is darker.
std::vector<std::uint8_t> small_picture(const Grid& grid, const std::vector<float>& heights_m,
                                        const std::vector<float>& depths_m, glm::ivec2 size);

}  // namespace talus::app
