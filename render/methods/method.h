#pragma once
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "render/camera.h"
#include "render/pyramid.h"
#include "sim/gpu/texture.h"

namespace talus {

/// What a method draws from and into.
struct Frame {
    const Terrain& terrain;
    const Pyramid& pyramid;
    const Camera& camera;
    int width;  ///< of the picture; the target may be larger
    int height;
    const gpu::Framebuffer&
        hits;  ///< RG32F: distance along the pixel's ray (m, infinity: nothing hit), steps
};

/// One way of drawing the surface: fills the frame's hits. Shading, depth output and views follow from those.
using Method = std::function<void(const Frame&)>;

/// A method by name, and how it is made. Adding one is a file in this folder and a line in methods().
struct MethodEntry {
    std::string name;
    std::string help;
    std::function<Method(bool count_steps)> make;  ///< count_steps: hits tell how many cells each ray visited
};
const std::vector<MethodEntry>& methods();

Method make_exact(bool count_steps);

}  // namespace talus
