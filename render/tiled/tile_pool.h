#pragma once
#include <span>
#include <vector>

#include "sim/gpu/buffer.h"
#include "sim/gpu/program.h"
#include "sim/gpu/texture.h"
#include "sim/tiled/tile_tree.h"

namespace talus::render {

/// The place on the device that holds tiles: slots of one size, each with a tile's samples and a pyramid of
/// their highest ones, which is built here (Dick, Krüger & Westermann 2009, section 3.2).
class TilePool {
  public:
    /// slots: at least 1; fewer are made where an image of the device has not so much room.
    TilePool(const TileTree& tree, int slots);

    int slots() const { return slots_; }
    /// Where a slot lies, as shaders take it (shaders/render/tile_surface.glsl): its column and 4096 times
    /// its row.
    int column_and_row(int slot) const { return slot % in_row_ + 4096 * (slot / in_row_); }
    std::size_t bytes() const;
    /// Device bytes of one slot of a tree's tiles.
    static std::size_t bytes_of_slot(const TileTree& tree);

    /// heights: of TileTree::samples_of() the tile that the slot holds from now on. Follow it with build().
    void write(int slot, glm::ivec2 samples, std::span<const float> heights);
    /// Builds the pyramids of the slots written since it was called last.
    void build();
    /// The heights of all slots, and where in them a slot's first sample is.
    const gpu::Texture& heights() const { return heights_; }
    glm::ivec2 heights_corner(int slot) const;
    /// Binds what shaders/render/slot_layout.glsl needs, and the images.
    void bind(gpu::Program& program) const;

  private:
    void set_layout(gpu::Program& program) const;

    int room_patches_;
    int top_level_;
    int in_row_;
    int slots_;
    gpu::Texture heights_;
    gpu::Texture tops_;
    gpu::Program pyramid_;
    gpu::Buffer list_;
    std::vector<std::uint32_t> written_;
    std::vector<float> room_;  // a slot's samples, filled up
};

}  // namespace talus::render
