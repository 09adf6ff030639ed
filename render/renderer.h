#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "render/camera.h"
#include "render/hits_target.h"
#include "render/methods/method.h"
#include "render/pyramid.h"
#include "render/redraw.h"
#include "render/refinement.h"
#include "render/ring.h"
#include "render/shading.h"
#include "render/tiled/backdrop.h"
#include "render/view.h"
#include "render/water_shading.h"
#include "render/water_surface.h"
#include "sim/gpu/readback.h"

namespace talus::render {

/// How much of a picture had to be drawn.
enum class Drawn { nothing, colours, changes, everything };

/// Draws a terrain into its own framebuffer: a method fills the hits, one shader colours them for every
/// method. What would keep its bits is not drawn again.
class Renderer {
  public:
    /// patch_pixels: as measure_patch_pixels() tells for the device.
    Renderer(const Terrain& terrain, double patch_pixels);

    /// Brings the pyramid up to date with the terrain's changed tiles and draws width x height pixels: all of
    /// them, only what changed tiles can touch, only the colours, or nothing. The picture is the same bit for
    /// bit as a fresh one. The ring lies on top: moving it draws nothing else again.
    Drawn draw(const Terrain& terrain, const Camera& camera, const ViewSettings& settings, int width,
               int height, const Ring& ring = {});
    /// Adds one sample per pixel to the picture drawn last, up to `samples`: smoother silhouettes and detail.
    /// Returns false if the picture did not change. The bits of the mean do not depend on the steps in which
    /// it was made.
    bool refine(const Terrain& terrain, int samples);
    /// The next draw() draws everything.
    void forget() {
        drawn_.reset();
        if (backdrop_) backdrop_->forget();
    }
    /// What stands around the terrain in its pictures from now on; null: nothing. It must outlive that.
    void stand_before(Backdrop* backdrop) {
        backdrop_ = backdrop;
        forget();
    }
    /// An image over the whole terrain (render/shading.h).
    void drape(int width, int height, std::span<const std::byte> rgba);
    /// A photo in tiles over it instead, which must live until another one, or none, is laid. It must have
    /// looked from the camera's eye. Two with the same `changes` count as one picture.
    void lay(const LaidPhoto& photo) { photo_ = photo; }

    /// What draw() made: rows bottom up; textures may be larger than the picture.
    const gpu::Framebuffer& framebuffer() const {
        return ringed_ ? ringed_buffer_ : refined() ? refinement_.mean_buffer() : colour_buffer_;
    }
    /// The same as a texture.
    const gpu::Texture& colours() const {
        return ringed_ ? ringed_colour_ : refined() ? refinement_.mean() : colour_;
    }
    /// Distance in metres along each pixel's normalised ray (infinity: nothing hit) and steps, of what stands
    /// around too.
    const gpu::Texture& hits() const { return backdrop_ ? backdrop_->hits() : target_.hits(); }
    const Pyramid& pyramid() const { return pyramid_; }

    /// The picture with its ring, top row first; waits for the device.
    std::vector<std::uint8_t> read_rgb(int width, int height) const;
    std::vector<float> read_depth(int width, int height) const;
    /// Lowest and highest sample of the terrain, a frame or two old: read without waiting. 0 before the
    /// second frame.
    glm::dvec2 bounds() const { return bounds_; }

  private:
    // What a picture was drawn from.
    struct Picture {
        Camera camera;
        ViewSettings settings;
        int width = 0;
        int height = 0;
        std::uint64_t changes = 0;
        std::uint64_t around = 0;  // of what stands around
        std::uint64_t photo = 0;   // and of the photo over it
        bool operator==(const Picture&) const = default;
    };

    void resize(int width, int height);
    void follow_bounds(bool again);
    bool refined() const { return refinement_.samples() > 1; }
    const Method& method_of(const Picture& picture, const char* use, bool& redraws_blocks);
    Drawn redraw(const Terrain& terrain, const Picture& picture, const std::optional<Picture>& before);
    void follow_sky(const Terrain& terrain, const ViewSettings& settings);
    void shade(const Terrain& terrain, const Picture& picture, const Redraw* redraw);
    /// Colours the hits into the target, water included; a redraw is for terrain without water alone.
    void colour(const Terrain& terrain, const Picture& picture, const gpu::Texture& hits,
                const gpu::Framebuffer& target, const Redraw* redraw, bool is_kept);
    void draw_ring(const Grid& grid);
    gpu::Region ring_region(const Picture& picture) const;

    Pyramid pyramid_;
    SkyView sky_view_;
    Backdrop* backdrop_ = nullptr;
    LaidPhoto photo_;
    Redraw redraw_;
    std::optional<Picture> drawn_;
    std::optional<std::uint64_t> refreshed_changes_;  // of the terrain that the pyramid knows
    std::optional<std::uint64_t> sky_changes_;        // of the terrain that the view of the sky knows
    struct MadeMethod {
        std::string name;
        std::string use;
        Detail detail;
        Method method;
    };
    std::vector<MadeMethod> methods_;
    Shading shading_;
    std::unique_ptr<WaterSurface> water_;  // none: no water was ever here
    WaterShading water_shading_;
    gpu::Texture ground_colour_;  // the picture under the water
    gpu::Framebuffer ground_colour_buffer_;
    gpu::Program ring_;
    std::optional<gpu::Program> stamp_ring_;  // once a stamp was shown
    double patch_pixels_;
    HitsTarget target_;
    Refinement refinement_;
    gpu::Texture colour_;
    gpu::Texture ringed_colour_;
    gpu::Framebuffer colour_buffer_;
    gpu::Framebuffer ringed_buffer_;
    bool ringed_ = false;
    Ring ring_on_;
    gpu::Readback lowest_readback_;
    gpu::Readback highest_readback_;
    glm::dvec2 bounds_{0};
    bool bounds_stale_ = true;
};

}  // namespace talus::render
