#pragma once
#include <bit>
#include <cstddef>
#include <glm/glm.hpp>
#include <vector>

#include "sim/terrain/grid.h"

namespace talus {

/// A tile of a tiled terrain: its level (0 is the finest), its column and row among the tiles of this level.
struct TileId {
    int level = 0;
    int column = 0;
    int row = 0;
    bool operator==(const TileId&) const = default;
};

/// A level of a tiled terrain's resolution pyramid.
struct TileLevel {
    glm::ivec2 samples;  ///< in a row and in a column
    glm::dvec2 ratio;    ///< samples of the finest level for one of this, along rows and columns
    glm::ivec2 tiles;    ///< in a row and in a column
};

/// A rectangle of a level's samples: `count` from the `first` one on, some of them beside the level's first
/// or last sample, where the edge's sample stands for them.
struct TileSamples {
    glm::ivec2 first;
    glm::ivec2 count;
};

/// Where the samples of a level stand among those of the finest.
enum class LevelPlaces {
    by_count,  ///< evenly: as many of the finest for one of the level as there are more of them
    by_halves  ///< each is the mean of 2 x 2 of the level before (halved_levels())
};

/// How a large terrain is cut into tiles (Dick, Krüger & Westermann 2009, section 4). A tile of level l
/// covers side * 2^l patches of the finest level in a row and in a column, cut off at the terrain's edge, so
/// four tiles of the level below lie in it. Sample i of level l stands for the area of the finest samples
/// that were averaged for it: at column (i + 1/2) * ratio - 1/2 of the finest level. So the surface of a
/// coarser level has its patches elsewhere than the tile has its edges; beyond its outermost
/// samples the surface is flat.
class TileTree {
  public:
    /// side: patches of the finest level in a row of a tile of level 0, a power of two from 16 on.
    /// level_samples: of each level, the finest first; a level has about half as many in a row and in a
    /// column as the one before. Levels beyond the one that is a single tile are left out. Throws
    /// talus::Error where side or the finest level are not so.
    TileTree(const Grid& grid, int side, const std::vector<glm::ivec2>& level_samples,
             LevelPlaces places = LevelPlaces::by_count);

    const Grid& grid() const { return grid_; }
    int side() const { return side_; }
    /// side() is two to this power.
    int side_level() const { return std::countr_zero(static_cast<unsigned>(side_)); }
    const std::vector<TileLevel>& levels() const { return levels_; }
    const TileLevel& level(int number) const { return levels_[static_cast<std::size_t>(number)]; }
    int top_level() const { return static_cast<int>(levels_.size()) - 1; }

    /// Where a column or row of the finest level lies among the samples of a level.
    glm::dvec2 place_in(int level, glm::dvec2 finest) const;
    /// The tile's edges in columns and rows of the finest level.
    glm::ivec2 first_patch(const TileId& tile) const;
    glm::ivec2 last_patch(const TileId& tile) const;
    /// The level's patch in which the tile's first edges lie.
    glm::ivec2 first_level_patch(const TileId& tile) const;
    /// What the tile's surface and its slopes stand on: from the sample before first_level_patch() to the one
    /// behind the patch of the last edges.
    TileSamples samples_of(const TileId& tile) const;
    /// So many patches in a row and in a column, from first_level_patch() on, hold all patches of any tile
    /// and the one behind them. A multiple of 16.
    int room_patches() const { return room_patches_; }

    /// Number of all tiles, and a tile's place among them: the finest level first, row by row.
    std::size_t count() const { return first_of_level_.back(); }
    std::size_t index_of(const TileId& tile) const;
    /// The place of a level's first tile among all; of the level after the coarsest: count().
    std::size_t first_of(int level) const { return first_of_level_[static_cast<std::size_t>(level)]; }
    TileId tile_at(std::size_t index) const;
    /// Of the coarsest level, which are held always.
    std::vector<TileId> coarsest_tiles() const;

  private:
    Grid grid_;
    int side_;
    int room_patches_;
    std::vector<TileLevel> levels_;
    std::vector<std::size_t> first_of_level_;  // and the number of all
};

/// Sizes of levels where each sample of one is the mean of 2 x 2 of the level before, down to a single
/// sample.
std::vector<glm::ivec2> halved_levels(glm::ivec2 samples);

}  // namespace talus
