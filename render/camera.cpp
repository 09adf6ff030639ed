#include "render/camera.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace talus::render {

CameraRays camera_rays(const Camera& camera, double width, double height) {
    const glm::dvec3 forward = glm::normalize(camera.target - camera.eye);
    const double level = std::hypot(forward.x, forward.y);
    const glm::dvec3 right =
        level > 1e-9 ? glm::dvec3(forward.y / level, -forward.x / level, 0) : glm::dvec3(1, 0, 0);
    const glm::dvec3 up = glm::cross(right, forward);
    const double reach =
        camera.is_parallel() ? camera.parallel_m / 2 : std::tan(camera.fov_deg * std::numbers::pi / 360);
    // The view's aspect, of which the picture may be a part.
    const double aspect = width / camera.window_share.x / (height / camera.window_share.y);
    const glm::dvec3 across = right * (reach * aspect);
    const glm::dvec3 upwards = up * reach;
    const glm::dvec3 aside = across * camera.window_middle.x + upwards * camera.window_middle.y;
    const glm::dvec3 to_right = across * camera.window_share.x;
    const glm::dvec3 to_top = upwards * camera.window_share.y;
    if (camera.is_parallel())
        return {forward, forward, glm::dvec3(0), glm::dvec3(0), aside, to_right, to_top};
    return {forward, forward + aside, to_right, to_top};
}

glm::dvec2 pixel_width_m(const Camera& camera, int height) {
    if (camera.is_parallel()) return {camera.parallel_m * camera.window_share.y / height, 0};
    return {0, 2 * std::tan(camera.fov_deg * std::numbers::pi / 360) * camera.window_share.y / height};
}

double pixel_width_m(const Camera& camera, int height, double distance_m) {
    const glm::dvec2 width_m = pixel_width_m(camera, height);
    return width_m.x + width_m.y * distance_m;
}

CastOrigin cast_origin(const Grid& grid, glm::dvec3 point) {
    const double column = std::clamp(grid.column_of(point.x), -1e9, 1e9);
    const double row = std::clamp(grid.row_of(point.y), -1e9, 1e9);
    return {glm::ivec2(std::floor(column), std::floor(row)),
            glm::dvec2(column - std::floor(column), row - std::floor(row)), point.z};
}

std::optional<glm::dvec2> place_in_picture(const Camera& camera, const CameraRays& rays, glm::dvec3 point) {
    const glm::dvec3 from_eye = point - camera.eye;
    const double depth = glm::dot(from_eye, rays.forward);
    if (camera.is_parallel()) {
        const glm::dvec3 aside = from_eye - rays.start;
        return glm::dvec2(glm::dot(aside, rays.start_right) / glm::dot(rays.start_right, rays.start_right),
                          glm::dot(aside, rays.start_up) / glm::dot(rays.start_up, rays.start_up));
    }
    if (depth < 0.05 * glm::length(from_eye)) return std::nullopt;
    const glm::dvec3 aside = from_eye / depth - rays.middle;
    return glm::dvec2(glm::dot(aside, rays.right) / glm::dot(rays.right, rays.right),
                      glm::dot(aside, rays.up) / glm::dot(rays.up, rays.up));
}

void set_camera(gpu::Program& program, const Grid& grid, const Camera& camera, int width, int height) {
    const CameraRays rays = camera_rays(camera, width, height);
    const CastOrigin origin = cast_origin(grid, camera.eye);
    const auto high = static_cast<float>(origin.height_m);
    program.set("picture_size", glm::vec2(width, height));
    program.set("view_axis", glm::vec3(rays.forward));
    program.set("ray_forward", glm::vec3(rays.middle));
    program.set("ray_right", glm::vec3(rays.right));
    program.set("ray_up", glm::vec3(rays.up));
    program.set("start_m", glm::vec3(rays.start));
    program.set("start_right_m", glm::vec3(rays.start_right));
    program.set("start_up_m", glm::vec3(rays.start_up));
    program.set("pixel_width_m", glm::vec2(pixel_width_m(camera, height)));
    program.set("cell_m", glm::vec2(grid.dx, grid.dy));
    program.set("cells_per_m", glm::vec2(1 / grid.dx, 1 / grid.dy));
    program.set("patches", glm::ivec2(grid.nx - 1, grid.ny - 1));
    program.set("origin_cell", origin.cell);
    program.set("origin_fraction", glm::vec2(origin.fraction));
    program.set("origin_height_m", glm::vec2(high, origin.height_m - high));
}

}  // namespace talus::render
