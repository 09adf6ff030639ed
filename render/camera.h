#pragma once
#include <glm/glm.hpp>
#include <optional>

#include "sim/gpu/program.h"
#include "sim/terrain/grid.h"

namespace talus::render {

/// Where the eye is and looks: world metres (x east, y north, z up), vertical field of view in degrees, up is
/// +z. Looking straight up or down, the picture's top is north.
struct Camera {
    glm::dvec3 eye{0, 0, 0};
    glm::dvec3 target{0, 1, 0};
    double fov_deg = 50;
    /// The part of the view that the picture shows: its middle from -1 to 1 across and up, and its share of
    /// both sides. A tile of a larger picture, or a shift within a pixel.
    glm::dvec2 window_middle{0, 0};
    glm::dvec2 window_share{1, 1};
    bool operator==(const Camera&) const = default;
};

/// A camera's rays before normalisation: middle + x * right + y * up for x, y from -1 to 1 over the picture.
struct CameraRays {
    glm::dvec3 forward;  ///< unit vector, the view's axis
    glm::dvec3 middle;   ///< forward, shifted to the window's middle
    glm::dvec3 right;
    glm::dvec3 up;
};
CameraRays camera_rays(const Camera& camera, double width, double height);

/// The width of a pixel at one metre before the eye.
double pixel_at_one_metre(const Camera& camera, int height);

/// The eye as the caster wants it: its patch, the place in it, its height in two words.
struct CastOrigin {
    glm::ivec2 cell;
    glm::dvec2 fraction;
    double height_m;
};
CastOrigin cast_origin(const Grid& grid, glm::dvec3 point);

/// Where a point of the world is in the picture, from -1 to 1 to the right and up; none: beside or behind the
/// eye, less than a twentieth of its distance ahead.
std::optional<glm::dvec2> place_in_picture(const Camera& camera, const CameraRays& rays, glm::dvec3 point);

/// Sets the uniforms of shaders/render/picture.glsl and the origin's of surface.glsl.
void set_camera(gpu::Program& program, const Grid& grid, const Camera& camera, int width, int height);

}  // namespace talus::render
