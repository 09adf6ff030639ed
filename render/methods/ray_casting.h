#pragma once
#include <optional>

#include "render/methods/beams.h"
#include "render/methods/method.h"

namespace talus::render {

/// What rays go over, and what they may do besides walking to the patch.
struct RayOptions {
    std::vector<std::string> defines;  ///< for the shader of the rays
    bool flat_ends = false;            ///< end in cells that their beam found flat
    /// Set: fill what a mesh left. Binds the buffers of shaders/render/hybrid_list.glsl and
    /// hybrid_sectors.glsl.
    std::function<void(gpu::Program&)> bind_mesh = {};
    bool tiled = false;  ///< over terrain in tiles (shaders/render/tiled.frag); else exact.frag
};

/// Casts rays for a picture: from where beams end, and only where one of these found ground to look at.
class RayCasting {
  public:
    explicit RayCasting(const RayOptions& options);

    /// Sends the beams and lists the picture's blocks by what became of them. flatness: as in
    /// shaders/maths/beam.glsl, for flat ends.
    void cast_beams(const RayPicture& picture, double flatness = 0);
    /// Draws the rays; pixels of a mesh stay. If the picture has a Redraw, its blocks must be marked
    /// (Beams::mark_changes) and listed first.
    void draw(const RayPicture& picture);

    Beams& beams() { return beams_; }
    std::size_t bytes() const { return beams_.bytes() + lists_.bytes(); }

  private:
    bool flat_ends_;
    std::function<void(gpu::Program&)> bind_mesh_;  // none: there is no mesh
    Beams beams_;
    gpu::Program list_;
    gpu::Program nothing_;
    gpu::Program walk_;
    std::optional<gpu::Program> flat_;  // those of flat ends: not over tiles
    std::optional<gpu::Program> walk_or_flat_;
    gpu::Buffer lists_;
};

/// A method's frame as one that rays are cast for; not for longer than the frame.
RayPicture ray_picture(const Frame& frame);

/// A method that casts a ray for every pixel, with defines for shaders/render/exact.frag.
Method cast_rays(const std::vector<std::string>& defines);

}  // namespace talus::render
