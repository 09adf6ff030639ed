#pragma once
#include <glm/glm.hpp>

#include "sim/gpu/program.h"
#include "sim/terrain/grid.h"

namespace talus {

/// Where the eye is and looks: world metres (x east, y north, z up), vertical field of view in degrees, up is
/// +z. Looking straight up or down, the picture's top is north.
struct Camera {
    glm::dvec3 eye{0, 0, 0};
    glm::dvec3 target{0, 1, 0};
    double fov_deg = 50;
    bool operator==(const Camera&) const = default;
};

/// A camera's rays before normalisation: forward + x * right + y * up for x, y from -1 to 1 over the picture.
struct CameraRays {
    glm::dvec3 forward;
    glm::dvec3 right;
    glm::dvec3 up;
};
CameraRays camera_rays(const Camera& camera, double width, double height);

/// The eye as the caster wants it: its patch, the place in it, its height in two words.
struct CastOrigin {
    glm::ivec2 cell;
    glm::dvec2 fraction;
    double height_m;
};
CastOrigin cast_origin(const Grid& grid, glm::dvec3 point);

/// A view over the whole terrain from the south-west, for a first look.
Camera overview(const Grid& grid, double lowest_m, double highest_m);

/// Sets the uniforms of shaders/render/picture.glsl and the origin's of surface.glsl.
void set_camera(gpu::Program& program, const Grid& grid, const Camera& camera, int width, int height);

}  // namespace talus
