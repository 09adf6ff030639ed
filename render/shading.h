#pragma once
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>

#include "render/pyramid.h"
#include "render/redraw.h"
#include "render/shade_list.h"
#include "render/sky_view.h"
#include "render/tiled/photo_surface.h"
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

/// What of another ground in the same picture matters to the colours of this one (render/tiled/backdrop.h).
/// The sky's share is not heeded then: neither ground knows what of the sky the other one takes.
struct Beside {
    glm::dvec2 range_m;          ///< lowest and highest of the larger one
    double extent_m = 0;         ///< of the larger one
    glm::ivec2 first{0};         ///< where among the other's columns and rows this one's first is
    const gpu::Texture* shadow;  ///< 1 at pixels whose hit the other one shades
};

/// The ground as the shader that colours a picture reads it.
struct ShadedGround {
    const Grid& grid;
    bool tiled = false;         ///< in tiles (render/tiled); else held as a whole
    bool has_layer = true;      ///< it has what the view shows
    bool has_sky_share = true;  ///< it knows what of the sky each place sees
    std::function<void(gpu::Program&)> bind;
    bool has_hole = false;                        ///< in which another one stands
    std::optional<Beside> beside = std::nullopt;  ///< the other one; none: it is alone
    LaidPhoto photo{};                            ///< instead of its materials, where the photo covers it
    bool has_mask = false;                        ///< a painted one, which may say what it is made of
};
/// What sets the haze.
double extent_m(const ShadedGround& ground);
ShadedGround shaded_ground(const Terrain& terrain, const Pyramid& pyramid, const SkyView& sky,
                           const std::string& view);

/// Gives a program the layers of the terrain that a view's file reads (shaders/render/views).
void bind_layers(gpu::Program& program, const Terrain& terrain, const View& view);
/// Whether the terrain has any of the layers that the view shows.
bool has_what_it_shows(const View& view, const Terrain& terrain);
/// Gives a program the numbers that the file of the settings' view takes.
void set_numbers(gpu::Program& program, const ViewSettings& settings);

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
