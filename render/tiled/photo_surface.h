#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "render/tiled/tile_nodes.h"
#include "render/tiled/tile_slots.h"
#include "sim/tiled/photo.h"

namespace talus::render {

/// A photo in tiles on the device: those that are there, and which of them a picture shows (Dick, Krüger &
/// Westermann 2009, section 3.3).
class PhotoSurface {
  public:
    using Sample = PhotoTexel;
    using ReadTile = ReadTexels;
    /// What put() takes of a tile: more than it covers, so that a pixel's footprint ends within.
    static TileSamples samples_of(const TileTree& tree, const TileId& tile);
    /// Smaller pictures of them that put() takes behind them (with_smaller_pictures()).
    static constexpr int halvings = 4;
    /// Device bytes of one slot of a tree's tiles, and of the tree beside its slots.
    static std::size_t bytes_of_slot(const TileTree& tree);

    /// tree: photo_tree(). bounds: photo_bounds(). slots: more than the tree's coarsest tiles,
    /// which must be put() before the first look(). Throws talus::Error where they are too few.
    PhotoSurface(const TileTree& tree, std::vector<TileBounds> bounds, int slots);

    const TileTree& tree() const { return slots_.tree(); }
    int slots() const { return slots_.count(); }
    std::size_t bytes() const;
    /// Puts a tile's texels into a slot (TileSlots::put()).
    void put(const TileId& tile, std::span<const PhotoTexel> texels) { write(slots_.put(tile), texels); }
    /// The same for a tile that is not wanted yet, where there is a slot for it (TileSlots::put_aside()).
    void put_aside(const TileId& tile, std::span<const PhotoTexel> texels);

    /// Chooses what a picture shows: the coarsest tiles whose texels are at most `tolerance_px` wide. camera:
    /// over the photo (LaidPhoto::camera_over()).
    const TileChoice& look(const Camera& camera, glm::ivec2 size, double tolerance_px);
    /// What a picture would want that may come after the last one (TileSlots::look_ahead()).
    std::vector<TileId> look_ahead(const Camera& camera, glm::ivec2 size, double tolerance_px) {
        return slots_.look_ahead(camera, size, tolerance_px);
    }
    /// Binds what was looked at for shaders/render/photo.glsl, over a ground with so many of its texels for a
    /// column and a row. The picture is drawn from the eye of the last look.
    void bind(gpu::Program& program, glm::dvec2 texels_per_sample) const;

  private:
    void write(int slot, std::span<const PhotoTexel> texels);
    void tell_places();
    glm::ivec2 corner_of(int slot) const;

    int across_;  // texels of a slot in a row and in a column
    TileSlots slots_;
    TileNodes nodes_;
    int in_row_;
    gpu::Texture texels_;
    gpu::Texture places_;
    glm::dvec2 eye_{0};  // of the last look, among the finest texels
};

/// A photo over a ground. Nothing to be laid: surface is null.
struct LaidPhoto {
    const PhotoSurface* surface = nullptr;
    PhotoPlace place{};
    std::uint64_t changes = 0;  ///< another number where it shows something else
    bool covers_all = false;    ///< of the ground: its materials are seen nowhere

    /// The ground's camera in the photo's metres.
    Camera camera_over(const Grid& ground, const Camera& camera) const;
};

}  // namespace talus::render
