#pragma once
#include <memory>

#include "app/core/scene.h"
#include "app/core/still.h"
#include "sim/gpu/context.h"
#include "sim/simulation.h"

namespace talus::app {

/// Pictures of a scene while it runs, with legends whose ends stay what they are at first.
class RunPictures {
  public:
    /// Simulation and scene must outlive it. Throws talus::Error where the scene's picture or photo cannot be
    /// laid.
    RunPictures(const Scene& scene, Simulation& simulation, const gpu::Device& device, glm::ivec2 size);
    ~RunPictures();
    RunPictures(const RunPictures&) = delete;
    RunPictures& operator=(const RunPictures&) = delete;

    glm::ivec2 size() const { return size_; }
    /// The first look at the terrain as it was when this was made.
    const render::Camera& first_look() const { return first_look_; }
    /// The terrain as it is now. Rows of RGB from the top. Throws talus::Error where a photo's tile cannot be
    /// read.
    std::vector<std::uint8_t> take(const render::Camera& camera);

  private:
    struct Easel;
    glm::ivec2 size_;
    int samples_;
    render::Camera first_look_;
    std::vector<render::Legend> legends_;
    std::unique_ptr<Easel> easel_;
};

}  // namespace talus::app
