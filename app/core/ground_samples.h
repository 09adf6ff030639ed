#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>

#include "render/tiled/tiled_surface.h"
#include "sim/terrain/terrain.h"

namespace talus::app {

/// Samples of a ground that lie in an image on the device, and a place among them.
struct GroundSamples {
    const gpu::Texture* heights;
    glm::ivec2 corner;      ///< texel of the first one
    glm::ivec2 count;       ///< in a row and in a column
    glm::dvec2 place;       ///< column and row
    std::uint64_t which;    ///< another number where columns and rows are another's
    std::uint64_t changes;  ///< another number where their heights may have changed
};

/// The ground at a place: of a terrain that is held as a whole, or of the finest tile that is there. None
/// beside it.
std::optional<GroundSamples> ground_samples_of(const Terrain& terrain, glm::dvec2 place_m);
std::optional<GroundSamples> ground_samples_of(const render::TiledSurface& surface, glm::dvec2 place_m);

}  // namespace talus::app
