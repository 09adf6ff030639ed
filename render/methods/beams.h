#pragma once
#include <array>

#include <functional>
#include <string>
#include <vector>

#include "render/redraw.h"
#include "sim/gpu/texture.h"

namespace talus::render {

/// What rays are cast for: a picture of a ground.
struct RayPicture {
    glm::ivec2 size;
    const gpu::Framebuffer& hits;
    std::function<void(gpu::Program&)> bind;  ///< binds the ground and the camera
    Redraw* redraw = nullptr;                 ///< as Frame::redraw (render/methods/method.h)
};

/// Start depths for a picture's rays: beams of 8 x 8 pixels are cast first and stop before any of their rays
/// can meet ground (shaders/maths/beam.glsl). Starting there changes no bit of a hit; flat ends do change
/// bits.
class Beams {
  public:
    /// With defines for shaders/render/beam.frag, BEAM_FILE among them.
    explicit Beams(const std::vector<std::string>& defines);
    /// flatness: as in shaders/maths/beam.glsl, for programs made with FLAT_ENDS. `bind`: binds what these
    /// defines need besides.
    void cast(const RayPicture& picture, double flatness = 0,
              const std::function<void(gpu::Program&)>& bind = {});
    /// Marks the blocks where the last two casts, of the same picture, ended in flat cells otherwise.
    void mark_changes(const RayPicture& picture);
    /// Binds what the last cast found to the program's `beams`.
    void bind(gpu::Program& program) const { program.bind_sampled("beams", sets_[newest_].texture); }
    /// In a row and in a column.
    static glm::ivec2 count(glm::ivec2 picture);

    std::size_t bytes() const;

  private:
    struct Set {
        gpu::Texture texture;
        gpu::Framebuffer buffer;
    };
    gpu::Program program_;
    gpu::Program changes_;
    std::array<Set, 2> sets_;
    int newest_ = 0;
};

}  // namespace talus::render
