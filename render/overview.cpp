#include "render/overview.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace talus::render {
namespace {

// What the picture must hold: the corners of the terrain's box or, all around, circles through them.
std::vector<glm::dvec3> outline(const Grid& grid, double lowest_m, double highest_m, bool all_around) {
    std::vector<glm::dvec2> around;
    const glm::dvec2 size(grid.width_m(), grid.height_m());
    if (all_around) {
        constexpr int corners = 64;
        // Its polygon holds the circle.
        const double radius = 0.5 * glm::length(size) / std::cos(std::numbers::pi / corners);
        for (int i = 0; i < corners; ++i) {
            const double angle = 2 * std::numbers::pi * i / corners;
            around.push_back(0.5 * size + radius * glm::dvec2(std::cos(angle), std::sin(angle)));
        }
    } else {
        around = {{0, 0}, {size.x, 0}, {0, size.y}, size};
    }
    std::vector<glm::dvec3> points;
    for (const glm::dvec2 at : around)
        for (const double z : {lowest_m, highest_m}) points.emplace_back(at, z);
    return points;
}

// The share of the picture's sides that the terrain may take.
constexpr double share = 0.94;

}  // namespace

Camera overview(const Grid& grid, double lowest_m, double highest_m, const Framing& framing) {
    const glm::dvec3 forward = glm::normalize(glm::dvec3(0.38, 0.80, -0.60));
    const glm::dvec3 right = glm::normalize(glm::cross(forward, glm::dvec3(0, 0, 1)));
    const glm::dvec3 up = glm::cross(right, forward);
    const double reach = share * std::tan(framing.fov_deg * std::numbers::pi / 360);
    const glm::dvec3 middle(grid.width_m() / 2, grid.height_m() / 2, (lowest_m + highest_m) / 2);
    // With the upper half of the terrain's cut sides, which fade below
    // (shaders/render/cut_face.glsl).
    const double face_m = 0.2 * std::max(highest_m - lowest_m, 1e-3 * glm::length(glm::dvec2(middle)));
    const std::vector<glm::dvec3> points = outline(grid, lowest_m - face_m, highest_m, framing.all_around);

    // For each of the picture's two axes: eye e sees point p if |dot(p - e, side)| <= k dot(p - e, forward).
    // The two signs together limit how far forward the eye may be, and give its place along the axis. The eye
    // stays before all of the terrain, by a tenth of its size at least: a wide view would come too near.
    double nearest = std::numeric_limits<double>::max();
    for (const glm::dvec3& p : points) nearest = std::min(nearest, glm::dot(p - middle, forward));
    double ahead = nearest - 0.1 * glm::distance(points.front(), points.back());
    glm::dvec2 aside(0);
    const std::array<glm::dvec3, 2> sides = {right, up};
    const std::array<double, 2> slopes = {reach * framing.aspect, reach};
    for (int i = 0; i < 2; ++i) {
        glm::dvec2 most(-std::numeric_limits<double>::max());
        for (const glm::dvec3& p : points) {
            const double along = glm::dot(p - middle, sides[static_cast<std::size_t>(i)]);
            const double back = slopes[static_cast<std::size_t>(i)] * glm::dot(p - middle, forward);
            most = glm::max(most, glm::dvec2(along - back, -along - back));
        }
        aside[i] = (most.x - most.y) / 2;
        ahead = std::min(ahead, -(most.x + most.y) / (2 * slopes[static_cast<std::size_t>(i)]));
    }
    Camera camera;
    camera.fov_deg = framing.fov_deg;
    camera.eye = middle + aside.x * right + aside.y * up + ahead * forward;
    camera.target = camera.eye + glm::dot(middle - camera.eye, forward) * forward;
    return camera;
}

Camera top_view(const Grid& grid, double highest_m, const Framing& framing) {
    Camera camera;
    camera.fov_deg = framing.fov_deg;
    camera.parallel_m = std::max(grid.height_m(), grid.width_m() / framing.aspect) / share;
    camera.eye = {grid.width_m() / 2, grid.height_m() / 2, highest_m};
    camera.target = camera.eye - glm::dvec3(0, 0, 1);
    keep_over(camera, grid, highest_m);
    return camera;
}

void keep_over(Camera& camera, const Grid& grid, double highest_m) {
    const double extent_m = std::max(grid.width_m(), grid.height_m());
    // As much as water may stand over the ground. In steps, so that the picture stays the same while a brush
    // raises the ground.
    if (camera.eye.z >= highest_m + 0.1 * extent_m) return;
    const double rise_m = highest_m + 0.2 * extent_m - camera.eye.z;
    camera.eye.z += rise_m;
    camera.target.z += rise_m;
}

}  // namespace talus::render
