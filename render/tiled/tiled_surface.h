#pragma once
#include <cstdint>
#include <map>
#include <optional>
#include <unordered_map>
#include <vector>

#include "render/tiled/tile_choice.h"
#include "render/tiled/tile_pool.h"

namespace talus::render {

/// A tiled terrain on the device: the tiles that are there, and which of them a picture shows.
class TiledSurface {
  public:
    /// bounds: of all tiles of the tree. slots: of the pool, more than the tree's coarsest tiles, which must
    /// be put() before the first look(). Throws talus::Error where an image of the device holds too few.
    TiledSurface(TileTree tree, std::vector<TileBounds> bounds, int slots);

    const TileTree& tree() const { return tree_; }
    const std::vector<TileBounds>& bounds() const { return bounds_; }
    int slots() const { return pool_.slots(); }
    std::size_t bytes() const;
    /// Device bytes that a tree takes beside its slots.
    static std::size_t bytes_of_nodes(const TileTree& tree);
    float lowest_m() const { return lowest_m_; }    ///< of all samples
    float highest_m() const { return highest_m_; }  ///< likewise
    /// The slot that a tile is in, or -1.
    int slot_of(const TileId& tile) const;
    /// Where the samples of the finest tile are that is on the device and holds a place.
    struct HeldTile {
        TileId tile;
        const gpu::Texture* heights;
        glm::ivec2 corner;  ///< texel of its first sample
    };
    /// finest: column and row of the finest level. None: beside the terrain.
    std::optional<HeldTile> finest_at(glm::dvec2 finest) const;
    /// Puts a tile's samples (TileTree::samples_of()) into a free slot, or into the one whose tile was not
    /// shown for the longest time. Tiles of the coarsest level stay. What is shown follows with the next
    /// look(): nothing may be drawn between.
    void put(const TileId& tile, std::span<const float> heights);
    /// The same for a tile that is not wanted yet, where there is a slot that neither the last two looks
    /// asked for nor a look ahead has a use for; else it is dropped.
    void put_aside(const TileId& tile, std::span<const float> heights);
    /// Takes all tiles away but those of the coarsest level.
    void clear();

    /// Chooses what a picture shows (choose_tiles()) and makes it known to the device.
    const TileChoice& look(const Camera& camera, glm::ivec2 size, double tolerance_px);
    /// Which tiles a picture would want that may come after the last one; the worst first, as many as
    /// put_aside() has slots for. Those that are there already are kept for it.
    std::vector<TileId> look_ahead(const Camera& camera, glm::ivec2 size, double tolerance_px);
    /// How far off the surface that is shown may be from the finest one, m for each metre of distance, when
    /// all tiles are there that the last look asked for.
    double off_m(const Camera& camera, glm::ivec2 size) const;
    /// Binds what was looked at for shaders/render/tile_surface.glsl, with the camera.
    void bind(gpu::Program& program, const Camera& camera, glm::ivec2 size) const;

  private:
    struct Slot {
        TileId tile{-1, 0, 0};
        std::uint64_t shown = 0;  // twice the look that showed it last, and 1 where it was asked for
    };

    TileChoice choose(const Camera& camera, glm::ivec2 size, double tolerance_px) const;
    int slot_to_fill() const;
    bool is_spare(const Slot& slot) const;
    void tell_nodes();
    void tell_places(const Camera& camera);

    TileTree tree_;
    std::vector<TileBounds> bounds_;
    float lowest_m_ = 0;
    float highest_m_ = 0;
    TilePool pool_;
    std::vector<Slot> slots_;
    std::unordered_map<std::size_t, int> slot_of_tile_;  // by TileTree::index_of()
    std::uint64_t looks_ = 0;
    TileChoice choice_;
    // Texels of nodes by TileTree::index_of(): highest point, slot.
    using NodeTexels = std::map<std::size_t, glm::vec2>;
    NodeTexels told_nodes_;
    gpu::Texture nodes_;
    gpu::Texture places_;
};

}  // namespace talus::render
