#pragma once
#include <map>
#include <vector>

#include "render/tiled/tile_choice.h"
#include "sim/gpu/program.h"
#include "sim/gpu/texture.h"

namespace talus::render {

/// The tree of tiles on the device (shaders/render/tile_nodes.glsl): for each tile whether it is drawn, and
/// from which slot.
class TileNodes {
  public:
    /// Throws talus::Error where the tree has more tiles than an image of the device has texels a side.
    explicit TileNodes(const TileTree& tree);

    /// Makes a choice known (TileChoice::nodes). Texels that stay are not written again.
    void tell(const TileTree& tree, const std::vector<TileNode>& nodes);
    const gpu::Texture& texture() const { return nodes_; }
    /// Device bytes that a tree takes.
    static std::size_t bytes_of(const TileTree& tree);

  private:
    // By TileTree::index_of(): highest point, slot.
    using Texels = std::map<std::size_t, glm::vec2>;

    Texels told_;
    gpu::Texture nodes_;
};

}  // namespace talus::render
