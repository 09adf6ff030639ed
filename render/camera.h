#pragma once
#include <glm/glm.hpp>
#include <optional>

#include "sim/gpu/program.h"
#include "sim/terrain/grid.h"

namespace talus::render {

/// Where the eye is and looks: world metres (x east, y north, z up), vertical field of view in degrees, up is
/// +z. Looking straight up or down, the picture's top is north. Rays run through the eye (perspective) or are
/// parallel (orthographic).
struct Camera {
    glm::dvec3 eye{0, 0, 0};
    glm::dvec3 target{0, 1, 0};
    double fov_deg = 50;
    /// The part of the view that the picture shows: its middle from -1 to 1 across and up, and its share of
    /// both sides. A tile of a larger picture, or a shift within a pixel.
    glm::dvec2 window_middle{0, 0};
    glm::dvec2 window_share{1, 1};
    /// Above 0: all rays are parallel to the view's axis and start in the plane through the eye, and the view
    /// is so many metres high. 0: they run through the eye.
    double parallel_m = 0;
    bool is_parallel() const { return parallel_m > 0; }
    bool operator==(const Camera&) const = default;
};

/// A camera's rays, for x, y from -1 to 1 over the picture: from start + x * start_right + y * start_up,
/// metres from the eye, along middle + x * right + y * up, before normalisation. Of a perspective view the
/// first three are 0, of a parallel one `right` and `up`.
struct CameraRays {
    glm::dvec3 forward;  ///< unit vector, the view's axis
    glm::dvec3 middle;   ///< forward, shifted to the window's middle
    glm::dvec3 right;
    glm::dvec3 up;
    glm::dvec3 start{0};
    glm::dvec3 start_right{0};
    glm::dvec3 start_up{0};
};
CameraRays camera_rays(const Camera& camera, double width, double height);

/// The width of a pixel, m: x + y times the distance along its ray.
glm::dvec2 pixel_width_m(const Camera& camera, int height);
/// The same at a distance.
double pixel_width_m(const Camera& camera, int height, double distance_m);

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
