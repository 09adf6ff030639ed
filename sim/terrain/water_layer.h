#pragma once
#include <glm/glm.hpp>
#include <vector>

#include "sim/gpu/texture.h"
#include "sim/terrain/grid.h"

namespace talus {

/// The water on the device: depth as two words (m) and discharge east and north (m²/s) in one texel, and the
/// bed under it, in images with ghost samples beyond the map's edges: texel = sample + `ghosts`.
struct WaterLayer {
    static constexpr int ghosts = 2;

    explicit WaterLayer(const Grid& grid);

    /// The texels of these samples.
    static gpu::Region texels(const gpu::Region& samples) {
        return {samples.x + ghosts, samples.y + ghosts, samples.width, samples.height};
    }

    gpu::Texture front;  ///< the water after the last whole sub-step
    gpu::Texture back;   ///< of a sub-step's first stage; front's water wherever tiles rest
    gpu::Texture bed;    ///< m: the ground, as the last tick found it
};

}  // namespace talus
