#pragma once
#include <optional>
#include <vector>

#include "render/tiled/tile_nodes.h"
#include "render/tiled/tile_pool.h"
#include "render/tiled/tile_slots.h"

namespace talus::render {

/// A tiled terrain on the device: the tiles that are there, and which of them a picture shows.
class TiledSurface {
  public:
    using Sample = float;
    using ReadTile = ReadSamples;
    /// What put() takes of a tile.
    static TileSamples samples_of(const TileTree& tree, const TileId& tile) { return tree.samples_of(tile); }

    /// bounds: of all tiles of the tree. slots: of the pool, more than the tree's coarsest tiles, which must
    /// be put() before the first look(). Throws talus::Error where they are too few.
    TiledSurface(TileTree tree, std::vector<TileBounds> bounds, int slots);

    const TileTree& tree() const { return slots_.tree(); }
    const std::vector<TileBounds>& bounds() const { return slots_.bounds(); }
    int slots() const { return pool_.slots(); }
    std::size_t bytes() const;
    /// Device bytes of one slot of a tree's tiles.
    static std::size_t bytes_of_slot(const TileTree& tree);
    float lowest_m() const { return lowest_m_; }    ///< of all samples
    float highest_m() const { return highest_m_; }  ///< likewise
    /// The slot that a tile is in, or -1.
    int slot_of(const TileId& tile) const { return slots_.slot_of(tile); }
    /// Where the samples of the finest tile are that is on the device and holds a place.
    struct HeldTile {
        TileId tile;
        const gpu::Texture* heights;
        glm::ivec2 corner;  ///< texel of its first sample
    };
    /// finest: column and row of the finest level. None: beside the terrain.
    std::optional<HeldTile> finest_at(glm::dvec2 finest) const;
    /// Puts a tile's samples (TileTree::samples_of()) into a slot (TileSlots::put()). What is shown follows
    /// with the next look(): nothing may be drawn between.
    void put(const TileId& tile, std::span<const float> heights);
    /// The same for a tile that is not wanted yet, where there is a slot for it (TileSlots::put_aside()).
    void put_aside(const TileId& tile, std::span<const float> heights);
    /// Takes all tiles away but those of the coarsest level.
    void clear() { slots_.clear(); }

    /// Chooses what a picture shows (choose_tiles()) and makes it known to the device.
    const TileChoice& look(const Camera& camera, glm::ivec2 size, double tolerance_px);
    /// What a picture would want that may come after the last one (TileSlots::look_ahead()).
    std::vector<TileId> look_ahead(const Camera& camera, glm::ivec2 size, double tolerance_px) {
        return slots_.look_ahead(camera, size, tolerance_px);
    }
    /// How far off the surface that is shown may be from the finest one, in pixels of the picture, when all
    /// tiles are there that the last look asked for.
    double off_px() const { return slots_.choice().tolerance_px; }
    /// Binds what was looked at for shaders/render/tile_surface.glsl, with the camera.
    void bind(gpu::Program& program, const Camera& camera, glm::ivec2 size) const;

  private:
    void tell_places(const Camera& camera);

    float lowest_m_ = 0;
    float highest_m_ = 0;
    TilePool pool_;
    TileSlots slots_;
    TileNodes nodes_;
    gpu::Texture places_;
};

}  // namespace talus::render
