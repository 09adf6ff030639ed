#pragma once
#include <vector>

#include "render/camera.h"
#include "shaders/maths/twin.h"

namespace talus::maths {

/// The CPU twin of the exact caster: the same maths over heights in main memory. In double it is the
/// reference that every method is measured against (law 1).
template <typename Real>
struct CastTwin {
    TALUS_TWIN_NAMES(Real)

    static constexpr bool count_steps = true;
    int2 patches{0};
    int top_level = 0;
    real2 cells_per_m{1};
    real3 ray_forward{0};
    real3 ray_right{0};
    real3 ray_up{0};
    real origin_height_m{0};
    std::vector<float> heights;
    std::vector<std::vector<float>> tops;  // by level - 1, rows of tops_width >> (level - 1)
    int tops_width = 0;

    CastTwin(const Grid& grid, std::vector<float> ground)
        : patches(grid.nx - 1, grid.ny - 1),
          cells_per_m(1 / grid.dx, 1 / grid.dy),
          heights(std::move(ground)) {
        const int side = max(patches.x, patches.y);
        while ((1 << top_level) < side && top_level < 8) ++top_level;
        top_level = max(top_level, 1);
        const int block = 1 << top_level;
        tops_width = (patches.x + block - 1) / block * block / 2;
        int rows = (patches.y + block - 1) / block * block / 2;
        for (int level = 1; level <= top_level; ++level, rows /= 2) {
            const int width = tops_width >> (level - 1);
            std::vector<float> cells(static_cast<std::size_t>(width) * rows, -HUGE_VALF);
            for (int y = 0; y < rows; ++y)
                for (int x = 0; x < width; ++x)
                    cells[static_cast<std::size_t>(y) * width + x] = highest_below(level, x, y);
            tops.push_back(std::move(cells));
        }
        for (const float top : tops.back()) highest_ = max(highest_, top);
        for (const float height : heights) lowest_ = min(lowest_, height);
    }

    float highest_below(int level, int x, int y) const {
        float bound = -HUGE_VALF;
        if (level > 1) {
            const int width = tops_width >> (level - 2);
            for (int i = 0; i < 4; ++i)
                bound = max(bound,
                            tops[level - 2][static_cast<std::size_t>(2 * y + i / 2) * width + 2 * x + i % 2]);
            return bound;
        }
        if (2 * x >= patches.x || 2 * y >= patches.y) return bound;
        for (int i = 0; i < 9; ++i) {
            const int column = min(2 * x + i % 3, patches.x);
            const int row = min(2 * y + i / 3, patches.y);
            bound = max(bound, heights[static_cast<std::size_t>(row) * (patches.x + 1) + column]);
        }
        return bound;
    }

    real load_top(int2 cell, int level) const {
        return real(
                   tops[level - 1][static_cast<std::size_t>(cell.y) * (tops_width >> (level - 1)) + cell.x]) -
               origin_height_m;
    }
    real load_highest() const { return real(highest_) - origin_height_m; }
    real4 load_corners(int2 at) const {
        const float* row = heights.data() + static_cast<std::size_t>(at.y) * (patches.x + 1) + at.x;
        const float* below = row + patches.x + 1;
        return real4(row[0], row[1], below[0], below[1]) - origin_height_m;
    }

#include "maths/cast.glsl"
#include "maths/march.glsl"

#include "maths/block_samples.glsl"
#include "maths/pixel_ray.glsl"

    /// Sets the camera for a picture; its pixels are then cast by position.
    void look(const Grid& grid, const render::Camera& camera, int width, int height) {
        const render::CameraRays rays = camera_rays(camera, width, height);
        const render::CastOrigin origin = render::cast_origin(grid, camera.eye);
        ray_forward = real3(rays.middle);
        ray_right = real3(rays.right);
        ray_up = real3(rays.up);
        origin_height_m = real(origin.height_m);
        cell_ = origin.cell;
        fraction_ = real2(origin.fraction);
    }

    /// The hit of the ray through a point of the picture, -1 to 1 from left to right and from bottom to top.
    CastHit cast_pixel(real x, real y) {
        return cast_ray(cell_, fraction_, pixel_ray(real2(x, y)), real(0), 5, real(0));
    }

    /// The same by relief mapping.
    CastHit march_pixel(real x, real y, int samples, int halvings) {
        const real2 bounds_m(real(lowest_) - origin_height_m, load_highest());
        return march_box(int2(0, 0), patches, bounds_m, cell_, fraction_, pixel_ray(real2(x, y)), samples,
                         halvings);
    }

    /// The same by samples of blocks of so many patches, one after the other.
    CastHit sample_pixel(real x, real y, int block_patches) {
        const real3 ray = pixel_ray(real2(x, y));
        const real2 inverse(cast_inverse(ray.x), cast_inverse(ray.y));
        const int2 side(ray.x < 0 ? 0 : 1, ray.y < 0 ? 0 : 1);
        const real relief_m =
            max(real(highest_) - real(lowest_), min(real(1) / cells_per_m.x, real(1) / cells_per_m.y));
        const real2 span = cast_span(int2(0), patches, load_highest(), cell_, fraction_, ray, inverse,
                                     cast_inverse(ray.z), side);
        CastHit hit{real(-1), 0};
        for (real at = span.x; at < span.y && hit.distance_m < 0;) {
            // A little ahead: on the far side of the plane between two blocks.
            const real2 place = fraction_ + (at + real(1e-9) * max(at, real(1))) * real2(ray);
            const int2 patch = glm::clamp(cell_ + int2(glm::floor(place)), int2(0), patches - 1);
            const int2 first = patch / block_patches * block_patches;
            const int2 last = glm::min(first + block_patches, patches);
            hit = sample_block(first, last, load_highest(), relief_m, real(0), cell_, fraction_, ray);
            const real2 over = cast_span(first, last, load_highest(), cell_, fraction_, ray, inverse,
                                         cast_inverse(ray.z), side);
            at = max(over.y, at * real(1 + 1e-9) + real(1e-9));
        }
        return hit;
    }

  private:
    float highest_ = -HUGE_VALF;
    float lowest_ = HUGE_VALF;
    int2 cell_{0};
    real2 fraction_{0};
};

}  // namespace talus::maths
