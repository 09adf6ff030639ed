#pragma once
#include <cstdint>
#include <functional>
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

/// Drapes the scene's picture over the terrain, or none. A photo is laid (app/core/paged_photo.h).
void drape(render::Renderer& renderer, const Scene& scene);

/// What draws the parts of a still: a terrain held as a whole, or one in tiles.
struct StillPainter {
    /// Told of each still before its parts. Null: it need not be told.
    std::function<void(const render::Camera&, glm::ivec2 size)> begin;
    std::function<void(const render::Camera&, glm::ivec2 size)> draw;  ///< afresh
    std::function<bool(int samples)> refine;                           ///< false: the picture has so many
    std::function<std::vector<std::uint8_t>(glm::ivec2 size)> read_rgb;
    std::function<std::vector<float>(glm::ivec2 size)> read_depth;
};
StillPainter painter_of(render::Renderer& renderer, const Terrain& terrain,
                        const render::ViewSettings& settings);

/// Draws a picture of any size, in parts where it is larger than 2048 pixels, with as many samples a pixel,
/// and legends in its lower right corner. The same terrain, camera and settings give the same picture.
Still draw_still(const StillPainter& painter, const render::Camera& camera,
                 const std::vector<render::Legend>& legends, glm::ivec2 size, int samples);

}  // namespace talus::app
