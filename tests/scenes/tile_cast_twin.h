#pragma once
#include <limits>
#include <unordered_map>
#include <vector>

#include "render/camera.h"
#include "render/tiled/tiled_surface.h"
#include "shaders/maths/twin.h"
#include "tests/scenes/memory_tiles.h"

namespace talus::maths {

/// The CPU twin of the caster over tiles: the same maths, over what a choice of tiles shows.
template <typename Real>
class TileCastTwin {
  public:
    TALUS_TWIN_NAMES(Real)
    static constexpr bool count_steps = true;
    static constexpr bool cast_once = true;

    explicit TileCastTwin(const scenes::MemoryTiles& tiles)
        : patches(tiles.tree().grid().nx - 1, tiles.tree().grid().ny - 1),
          tile_top_level(tiles.tree().top_level()),
          room_patches(tiles.tree().room_patches()),
          tiles_(tiles) {
        const Grid& grid = tiles.tree().grid();
        cells_per_m = real2(1 / grid.dx, 1 / grid.dy);
        while (1 << tile_side_level < tiles.tree().side()) ++tile_side_level;
        while (1 << slot_walk_level < room_patches.x) ++slot_walk_level;
    }

    /// The choice is one of this surface's.
    void look(const render::TileChoice& choice, const render::TiledSurface& surface,
              const render::Camera& camera, int width, int height) {
        nodes_.clear();
        for (const render::TileNode& node : choice.nodes) nodes_[tiles_.tree().index_of(node.tile)] = node;
        const Grid& grid = tiles_.tree().grid();
        const render::CameraRays rays = render::camera_rays(camera, width, height);
        origin_ = render::cast_origin(grid, camera.eye);
        ray_forward = real3(rays.middle);
        ray_right = real3(rays.right);
        ray_up = real3(rays.up);
        held_.resize(static_cast<std::size_t>(surface.slots()));
        for (const TileId& tile : choice.drawn)
            held_[static_cast<std::size_t>(surface.slot_of(tile))] = {tile, tiles_.read(tile)};
    }

#include "maths/tile_place.glsl"

    real2 load_tile_node(int2 tile, int level) const {
        const auto node = nodes_.find(tiles_.tree().index_of({level, tile.x, tile.y}));
        if (node == nodes_.end()) return real2(0, -2);
        return real2(over_eye(node->second.highest_m), node->second.slot);
    }

    TilePlace load_tile(int slot) {
        loaded_ = &held_[static_cast<std::size_t>(slot)];
        const TileTree& tree = tiles_.tree();
        const int level = loaded_->tile.level;
        const glm::dvec2 place = tree.place_in(level, glm::dvec2(origin_.cell) + origin_.fraction);
        const glm::dvec2 cell = level == 0 ? glm::dvec2(origin_.cell) : glm::floor(place);
        return {int2(cell) - tree.first_level_patch(loaded_->tile),
                real2(level == 0 ? origin_.fraction : place - cell), real2(1.0 / tree.level(level).ratio),
                level};
    }

    real load_highest() const {
        float highest = -std::numeric_limits<float>::infinity();
        for (const TileBounds& one : tiles_.bounds()) highest = std::max(highest, one.highest_m);
        return over_eye(highest);
    }

    real load_top(int2 cell, int level) const {
        real top = -std::numeric_limits<real>::infinity();
        for (int row = cell.y << level; row <= min((cell.y + 1) << level, room_patches.y); ++row)
            for (int column = cell.x << level; column <= min((cell.x + 1) << level, room_patches.x); ++column)
                top = max(top, sample(column, row));
        return top;
    }

    real4 load_corners(int2 at) const {
        return real4(sample(at.x, at.y), sample(at.x + 1, at.y), sample(at.x, at.y + 1),
                     sample(at.x + 1, at.y + 1));
    }

#include "maths/pixel_ray.glsl"
#include "maths/tile_cast.glsl"

    TileHit cast_pixel(real x, real y) {
        return cast_tiles(origin_.cell, real2(origin_.fraction), pixel_ray(real2(x, y)), real(0), 30, 0,
                          real(0), real2(real(0), real(1e30)));
    }

    /// The same around a hole of these patches.
    TileHit cast_pixel_around(int2 first, int2 end, real x, real y) {
        return cast_tiles_around(first, end, origin_.cell, real2(origin_.fraction), pixel_ray(real2(x, y)),
                                 real(0), 30, 0, real(0));
    }

    int2 patches;
    int tile_side_level = 0;
    int tile_top_level;
    int2 room_patches;
    int slot_walk_level = 1;
    real2 cells_per_m{1};
    real3 ray_forward{0};
    real3 ray_right{0};
    real3 ray_up{0};

  private:
    struct Held {
        TileId tile;
        std::vector<float> heights;
    };

    // The eye's height in two words, as shaders have it.
    real over_eye(float height) const {
        const auto high = static_cast<float>(origin_.height_m);
        return (real(height) - real(high)) - real(static_cast<float>(origin_.height_m - high));
    }

    real sample(int column, int row) const {
        const int2 count = tiles_.tree().samples_of(loaded_->tile).count;
        const float height = loaded_->heights[static_cast<std::size_t>(min(row + 1, count.y - 1)) * count.x +
                                              static_cast<std::size_t>(min(column + 1, count.x - 1))];
        return over_eye(height);
    }

    const scenes::MemoryTiles& tiles_;
    std::vector<Held> held_;  // by slot
    const Held* loaded_ = nullptr;
    std::unordered_map<std::size_t, render::TileNode> nodes_;  // by TileTree::index_of()
    render::CastOrigin origin_{};
};

}  // namespace talus::maths
