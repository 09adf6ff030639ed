#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "app/core/scene.h"
#include "render/renderer.h"

namespace talus::app {

/// A picture for a file: rows from the top.
struct Still {
    std::vector<std::uint8_t> rgb;
    std::vector<float> depth_m;  ///< along each pixel's ray
};

/// Drapes the scene's picture over the terrain, or none.
void drape(render::Renderer& renderer, const Scene& scene);

/// Draws a picture of any size, in tiles where it is larger than 2048 pixels, with as many samples a pixel,
/// and legends in its lower right corner. The same terrain, camera and settings give the same picture.
Still draw_still(render::Renderer& renderer, const Terrain& terrain, const render::Camera& camera,
                 const render::ViewSettings& settings, const std::vector<render::Legend>& legends,
                 glm::ivec2 size, int samples);

}  // namespace talus::app
