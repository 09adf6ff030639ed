#pragma once
#include <vector>

#include "sim/tiled/tile_bounds.h"

namespace talus::scenes {

/// A tiled terrain in main memory: levels by means of 2 x 2 samples.
class MemoryTiles {
  public:
    MemoryTiles(const Grid& grid, std::vector<float> heights, int side);

    const TileTree& tree() const { return tree_; }
    const std::vector<TileBounds>& bounds() const { return bounds_; }
    std::vector<float> read(const TileId& tile) const;
    void read(int level, const TileSamples& samples, std::vector<float>& heights) const;
    /// The level's bilinear surface at a place of the finest level, in double.
    double height_at(int level, glm::dvec2 finest) const;

  private:
    TileTree tree_;
    std::vector<std::vector<float>> levels_;
    std::vector<TileBounds> bounds_;
};

}  // namespace talus::scenes
