#include "app/window/camera_control.h"

#include <algorithm>
#include <cmath>

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

}  // namespace

void orbit(render::Camera& camera, glm::dvec3 pivot, double drag_x, double drag_y) {
    const double yaw = -drag_x * radians_per_pixel;
    const glm::dvec3 direction = camera.target - camera.eye;
    const double elevation = std::asin(std::clamp(direction.z / glm::length(direction), -1.0, 1.0));
    const double pitch = std::clamp(elevation - drag_y * radians_per_pixel, -1.55, 1.2) - elevation;
    const glm::dvec3 right = camera_rays(camera, 1, 1).right / glm::length(camera_rays(camera, 1, 1).right);
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
    const double per_pixel = pixel_at_one_metre(camera, picture_height) * distance_m;
    const render::CameraRays rays = camera_rays(camera, 1, 1);
    const glm::dvec3 move =
        glm::normalize(rays.right) * (-drag_x * per_pixel) + glm::normalize(rays.up) * (drag_y * per_pixel);
    camera.eye += move;
    camera.target += move;
}

void zoom(render::Camera& camera, glm::dvec3 towards, double steps) {
    const glm::dvec3 move = (towards - camera.eye) * (1 - std::pow(0.85, steps));
    camera.eye += move;
    camera.target += move;
}

void fly(render::Camera& camera, double ahead_m, double right_m, double up_m) {
    const render::CameraRays rays = camera_rays(camera, 1, 1);
    const glm::dvec3 move =
        rays.forward * ahead_m + glm::normalize(rays.right) * right_m + glm::dvec3(0, 0, up_m);
    camera.eye += move;
    camera.target += move;
}

void walk(render::Camera& camera, double ahead_m, double right_m) {
    const glm::dvec3 right = glm::normalize(camera_rays(camera, 1, 1).right);
    const glm::dvec3 move = glm::cross(glm::dvec3(0, 0, 1), right) * ahead_m + right * right_m;
    camera.eye += move;
    camera.target += move;
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

glm::dvec3 pixel_direction(const render::Camera& camera, double x, double y, int width, int height) {
    const render::CameraRays rays = camera_rays(camera, width, height);
    return glm::normalize(rays.middle + rays.right * (2 * x / width - 1) + rays.up * (1 - 2 * y / height));
}

}  // namespace talus::app
