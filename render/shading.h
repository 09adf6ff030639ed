#pragma once
#include <functional>
#include <map>
#include <span>
#include <string>

#include "render/pyramid.h"
#include "render/redraw.h"
#include "render/shade_list.h"
#include "render/sky_view.h"
#include "render/view.h"
#include "sim/gpu/texture.h"

namespace talus::render {

/// What is shaded: the hits of a picture.
struct ShadeFrame {
    const Camera& camera;
    const ViewSettings& settings;
    int width;  ///< of the picture; textures may be larger
    int height;
    const gpu::Texture& hits;
    const gpu::Framebuffer& target;
};

/// The ground as the shader that colours a picture reads it.
struct ShadedGround {
    const Grid& grid;
    bool tiled = false;         ///< in tiles (render/tiled); else held as a whole
    bool has_layer = true;      ///< it has what the view shows
    bool has_sky_share = true;  ///< it knows what of the sky each place sees
    std::function<void(gpu::Program&)> bind;
};
ShadedGround shaded_ground(const Terrain& terrain, const Pyramid& pyramid, const SkyView& sky,
                           const std::string& view);

/// Colours the hits of a picture: one program for each view and what it looks at, made when first used.
class Shading {
  public:
    Shading();

    /// An image over the whole terrain instead of its materials: rows of RGBA bytes, north first, its edges
    /// on the outer samples; alpha is not used. An empty image takes it away.
    void drape(int width, int height, std::span<const std::byte> rgba);

    /// Draws all of the picture, or the blocks of a redraw where one is given.
    void draw(const ShadeFrame& frame, const ShadedGround& ground, const Redraw* redraw);

  private:
    // `sky`: for blocks where nothing was hit.
    gpu::Program& program_of(const View& view, const ViewSettings& settings, bool sky,
                             const ShadedGround& ground);

    std::map<std::string, gpu::Program> programs_;
    ShadeList list_;
    gpu::Texture grain_;
    gpu::Texture drape_;
};

}  // namespace talus::render
