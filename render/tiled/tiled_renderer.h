#pragma once
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "render/hits_target.h"
#include "render/refinement.h"
#include "render/shading.h"
#include "render/tiled/tiled_rays.h"
#include "render/view.h"

namespace talus::render {

/// Whether a view can be drawn of terrain in tiles, which has no layer but the ground.
bool is_of_tiles(const View& view);
/// Throws talus::Error where the settings' view cannot.
void check_view_of_tiles(const ViewSettings& settings);

/// Whether a parameter of drawing can change a picture of terrain in tiles now (is_heeded() of
/// render/view.h).
bool is_heeded_in_tiles(const std::string& parameter, const Parameters& drawing, bool draped);

/// Its legend there.
std::vector<Legend> tiled_legend_of(const ViewSettings& settings, const TiledSurface& surface);

/// Draws a terrain in tiles into its own framebuffer: one ray a pixel over the tiles that are there, then the
/// colours of a view.
class TiledRenderer {
  public:
    /// Draws what the surface looked at last, from the same eye; the camera's window may be another. Throws
    /// talus::Error where the view is not is_of_tiles().
    void draw(const TiledSurface& surface, const Camera& camera, const ViewSettings& settings, int width,
              int height);
    /// Adds one sample per pixel to the picture drawn last, up to `samples`. Returns false if the picture did
    /// not change.
    bool refine(const TiledSurface& surface, int samples);
    /// An image over the whole terrain (render/shading.h).
    void drape(int width, int height, std::span<const std::byte> rgba);
    /// A photo in tiles instead (Renderer::lay()).
    void lay(const LaidPhoto& photo) { photo_ = photo; }

    /// What draw() and refine() made: rows bottom up; textures may be larger than the picture.
    const gpu::Framebuffer& framebuffer() const {
        return is_refined() ? refinement_.mean_buffer() : colour_buffer_;
    }
    const gpu::Texture& colours() const { return is_refined() ? refinement_.mean() : colour_; }
    /// Distance in metres along each pixel's normalised ray (infinity: nothing hit) and detail.
    const gpu::Texture& hits() const { return target_.hits(); }
    /// The picture, top row first; waits for the device.
    std::vector<std::uint8_t> read_rgb(int width, int height) const;
    std::vector<float> read_depth(int width, int height) const;

  private:
    struct Picture {
        Camera camera;
        ViewSettings settings;
        int width = 0;
        int height = 0;
    };

    void resize(int width, int height);
    void cast(const TiledSurface& surface, const Picture& picture, const gpu::Framebuffer& hits);
    void colour(const TiledSurface& surface, const Picture& picture, const gpu::Texture& hits,
                const gpu::Framebuffer& target);
    bool is_refined() const { return refinement_.samples() > 1; }

    std::map<Detail, TiledRays> rays_;
    Shading shading_;
    LaidPhoto photo_;
    HitsTarget target_;
    gpu::Texture colour_;
    gpu::Framebuffer colour_buffer_;
    Refinement refinement_;
    Picture drawn_;
};

}  // namespace talus::render
