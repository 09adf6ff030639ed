#pragma once
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "render/cast_twin.h"
#include "render/measure.h"
#include "tests/scenes/memory_tiles.h"
#include "tests/scenes/scenes.h"

namespace talus::scenes {

/// How far off a pixel is from the finest surface: by how many pixels the finest surface lies above or below
/// what is shown, where that place is seen; or how far the next reference ray is that agrees
/// (render/measure.h); or the limit, where what is shown lies between two depths that are seen within the
/// limit, on a crest.
class OffPixels {
  public:
    OffPixels(const Scene& scene, const MemoryTiles& tiles, glm::ivec2 size)
        : grid_(scene.grid),
          tiles_(tiles),
          size_(size),
          measure_(scene.grid, scene.heights),
          twin_(scene.grid, scene.heights) {}

    /// The pictures that follow are this camera's.
    void look(const render::Camera& camera, double limit_px) {
        camera_ = camera;
        rays_ = render::camera_rays(camera, size_.x, size_.y);
        limit_px_ = limit_px;
        twin_.look(grid_, camera, size_.x, size_.y);
    }

    double operator()(glm::ivec2 pixel, double distance_m) {
        const glm::dvec2 at = 2.0 * (glm::dvec2(pixel) + 0.5) / glm::dvec2(size_) - 1.0;
        if (!std::isinf(distance_m)) {
            const double off = off_above_or_below(at, distance_m);
            if (off <= limit_px_) return off;
        }
        if (on_a_crest(at, distance_m)) return limit_px_;
        return measure_.error_px(camera_, size_.x, size_.y, pixel.x, pixel.y, distance_m, limit_px_);
    }

  private:
    double off_above_or_below(glm::dvec2 at, double distance_m) {
        const glm::dvec3 way = glm::normalize(rays_.middle + at.x * rays_.right + at.y * rays_.up);
        glm::dvec3 point = camera_.eye + distance_m * way;
        point.z = tiles_.height_at(0, {grid_.column_of(point.x), grid_.row_of(point.y)});
        const auto place = render::place_in_picture(camera_, rays_, point);
        if (!place) return std::numeric_limits<double>::infinity();
        const double found = twin_.cast_pixel(place->x, place->y).distance_m;
        const bool seen = std::abs(found - glm::length(point - camera_.eye)) <= 1e-4 * found;
        return seen ? glm::length(0.5 * (*place - at) * glm::dvec2(size_))
                    : std::numeric_limits<double>::infinity();
    }

    bool on_a_crest(glm::dvec2 at, double distance_m) {
        double nearest = std::numeric_limits<double>::infinity();
        double farthest = 0;
        for (int ring = 1; ring <= 3; ++ring)
            for (int i = 0; i < 16; ++i) {
                const double angle = 2 * std::numbers::pi * i / 16;
                const glm::dvec2 aside =
                    limit_px_ * ring / 3.0 * glm::dvec2(std::cos(angle), std::sin(angle));
                const glm::dvec2 there = at + 2.0 * aside / glm::dvec2(size_);
                double found = twin_.cast_pixel(there.x, there.y).distance_m;
                if (found < 0) found = std::numeric_limits<double>::infinity();
                nearest = std::min(nearest, found);
                farthest = std::max(farthest, found);
            }
        return nearest <= distance_m * (1 + 1e-4) && farthest >= distance_m * (1 - 1e-4);
    }

    Grid grid_;
    const MemoryTiles& tiles_;
    glm::ivec2 size_;
    render::Camera camera_;
    render::CameraRays rays_{};
    double limit_px_ = 0;
    render::Measure measure_;
    maths::CastTwin<double> twin_;
};

}  // namespace talus::scenes
