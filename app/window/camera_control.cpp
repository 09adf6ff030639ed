#include "app/window/camera_control.h"

#include <algorithm>
#include <cmath>

#include "render/overview.h"

namespace talus::app {
namespace {

constexpr double radians_per_pixel = 0.005;

// Turns a vector about up by yaw, then towards up by pitch, short of straight up or down.
glm::dvec3 turned(glm::dvec3 v, double yaw, double pitch) {
    const double length = glm::length(v);
    double heading = std::atan2(v.y, v.x) + yaw;
    double elevation = std::asin(std::clamp(v.z / length, -1.0, 1.0)) + pitch;
    elevation = std::clamp(elevation, -1.553, 1.553);
    return length * glm::dvec3(std::cos(elevation) * std::cos(heading),
                               std::cos(elevation) * std::sin(heading), std::sin(elevation));
}

// Unit vectors to the picture's right and top.
struct Sides {
    glm::dvec3 right;
    glm::dvec3 up;
};
Sides sides_of(const render::Camera& camera) {
    const render::CameraRays rays = camera_rays(camera, 1, 1);
    return {glm::normalize(rays.right + rays.start_right), glm::normalize(rays.up + rays.start_up)};
}

}  // namespace

void orbit(render::Camera& camera, glm::dvec3 pivot, double drag_x, double drag_y) {
    const double yaw = -drag_x * radians_per_pixel;
    const glm::dvec3 direction = camera.target - camera.eye;
    const double elevation = std::asin(std::clamp(direction.z / glm::length(direction), -1.0, 1.0));
    const double pitch = std::clamp(elevation - drag_y * radians_per_pixel, -1.55, 1.2) - elevation;
    const glm::dvec3 right = sides_of(camera).right;
    // About the vertical through the pivot, then about the camera's own right through it.
    const auto about_up = [&](glm::dvec3 v) {
        return glm::dvec3(v.x * std::cos(yaw) - v.y * std::sin(yaw),
                          v.x * std::sin(yaw) + v.y * std::cos(yaw), v.z);
    };
    const auto about_right = [&](glm::dvec3 v) {
        return v * std::cos(pitch) + glm::cross(right, v) * std::sin(pitch) +
               right * (glm::dot(right, v) * (1 - std::cos(pitch)));
    };
    const glm::dvec3 eye = about_up(about_right(camera.eye - pivot)) + pivot;
    camera.target = eye + about_up(about_right(direction));
    camera.eye = eye;
}

void look(render::Camera& camera, double drag_x, double drag_y) {
    camera.target = camera.eye + turned(camera.target - camera.eye, -drag_x * radians_per_pixel,
                                        -drag_y * radians_per_pixel);
}

void look_level(render::Camera& camera) {
    const glm::dvec3 way = camera.target - camera.eye;
    camera.target = camera.eye + turned(way, 0, -std::asin(std::clamp(way.z / glm::length(way), -1.0, 1.0)));
}

void pan(render::Camera& camera, double drag_x, double drag_y, double distance_m, int picture_height) {
    const double per_pixel = pixel_width_m(camera, picture_height, distance_m);
    const Sides sides = sides_of(camera);
    const glm::dvec3 move = sides.right * (-drag_x * per_pixel) + sides.up * (drag_y * per_pixel);
    camera.eye += move;
    camera.target += move;
}

void zoom(render::Camera& camera, glm::dvec3 towards, double steps) {
    const glm::dvec3 move = (towards - camera.eye) * (1 - std::pow(0.85, steps));
    camera.eye += move;
    camera.target += move;
}

void fly(render::Camera& camera, double ahead_m, double right_m, double up_m) {
    const glm::dvec3 move = glm::normalize(camera.target - camera.eye) * ahead_m +
                            sides_of(camera).right * right_m + glm::dvec3(0, 0, up_m);
    camera.eye += move;
    camera.target += move;
}

void walk(render::Camera& camera, double ahead_m, double right_m) {
    const glm::dvec3 right = sides_of(camera).right;
    const glm::dvec3 move = glm::cross(glm::dvec3(0, 0, 1), right) * ahead_m + right * right_m;
    camera.eye += move;
    camera.target += move;
}

void look_from_top(render::Camera& camera, const Grid& grid, double highest_m, double aspect,
                   glm::dvec3 ground) {
    const double seen_m = 2 * std::tan(glm::radians(camera.fov_deg / 2)) * glm::distance(ground, camera.eye);
    camera = render::top_view(grid, highest_m, {aspect, camera.fov_deg});
    if (seen_m > 0.8 * camera.parallel_m) return;
    const glm::dvec2 middle =
        glm::clamp(glm::dvec2(ground), glm::dvec2(0), glm::dvec2(grid.width_m(), grid.height_m()));
    camera.parallel_m = std::max(seen_m, 0.05 * camera.parallel_m);
    camera.eye = {middle, camera.eye.z};
    camera.target = camera.eye - glm::dvec3(0, 0, 1);
}

void leave_top(render::Camera& camera, glm::dvec3 direction, double ground_m, bool walks) {
    const glm::dvec3 ahead = camera.parallel_m / (2 * std::tan(glm::radians(camera.fov_deg / 2))) * direction;
    const glm::dvec3 middle(camera.eye.x, camera.eye.y, ground_m);
    camera.eye = walks ? middle : middle - ahead;
    camera.target = camera.eye + ahead;
    camera.parallel_m = 0;
}

void zoom_from_top(render::Camera& camera, glm::dvec3 towards, double steps, const Grid& grid) {
    const double before_m = camera.parallel_m;
    // Another terrain may have left it beyond what is allowed: it does not jump there.
    const double least_m = std::min(before_m, 4 * std::min(grid.dx, grid.dy));
    const double most_m = std::max(before_m, 10 * std::max(grid.width_m(), grid.height_m()));
    camera.parallel_m = std::clamp(before_m * std::pow(0.85, steps), least_m, most_m);
    const glm::dvec2 move =
        (glm::dvec2(towards) - glm::dvec2(camera.eye)) * (1 - camera.parallel_m / before_m);
    camera.eye += glm::dvec3(move, 0);
    camera.target += glm::dvec3(move, 0);
}

void stand(render::Camera& camera, double height_m, double lowest_m, double passed_s) {
    const double share = 1 - std::exp(-passed_s / 0.1);
    double rise = (height_m - camera.eye.z) * share;
    // What no eye could see is the way done, so that a camera at rest stays the same to the bit.
    if (std::abs(height_m - camera.eye.z) < 1e-3) rise = height_m - camera.eye.z;
    camera.eye.z += rise;
    camera.target.z += rise;
    keep_above(camera, lowest_m);
}

void keep_within(render::Camera& camera, const Rectangle& ground) {
    const glm::dvec2 place(camera.eye);
    const glm::dvec2 move = glm::clamp(place, glm::dvec2(ground.west_m, ground.south_m),
                                       glm::dvec2(ground.east_m, ground.north_m)) -
                            place;
    camera.eye += glm::dvec3(move, 0);
    camera.target += glm::dvec3(move, 0);
}

void keep_above(render::Camera& camera, double lowest_m) {
    const double rise = std::max(0.0, lowest_m - camera.eye.z);
    camera.eye.z += rise;
    camera.target.z += rise;
}

PixelRay pixel_ray(const render::Camera& camera, double x, double y, int width, int height) {
    const render::CameraRays rays = camera_rays(camera, width, height);
    const double right = 2 * x / width - 1;
    const double up = 1 - 2 * y / height;
    return {camera.eye + rays.start + rays.start_right * right + rays.start_up * up,
            glm::normalize(rays.middle + rays.right * right + rays.up * up)};
}

}  // namespace talus::app
