#pragma once
#include <functional>
#include <vector>

#include "sim/tiled/tile_tree.h"

namespace talus {

/// What is known of a tile without its samples.
struct TileBounds {
    float lowest_m = 0;   ///< of its samples, those beside its edges included
    float highest_m = 0;  ///< likewise
    float error_m = 0;  ///< its surface is nowhere farther above or below the finest level's bilinear surface
    bool operator==(const TileBounds&) const = default;
};

/// Reads samples of a level, row by row: `count` from the `first` one on. Samples beside the level are those
/// of its edge. Throws talus::Error where they cannot be read.
using ReadSamples = std::function<void(int level, const TileSamples& samples, std::vector<float>& heights)>;

/// Bounds that were measured of a terrain of which some samples are others now.
struct BoundsBefore {
    std::vector<TileBounds> bounds;  ///< of all tiles
    TileSamples changed;             ///< of the finest level: no other sample is another
};

/// Bounds of all tiles, in the order of TileTree::index_of(). The error is the largest difference of the two
/// surfaces over the tile, worked out where it can be largest: both are bilinear between the columns and rows
/// of both levels' samples, so their difference is largest where two of those cross. It is rounded up.
/// make_reader: called once for each thread, whose reader no other uses. told: called
/// now and then, by one thread at a time, with about the share of the work that is done; where it returns
/// false, the work ends and nothing is returned. before: only what changed is measured; errors of coarser
/// tiles there are not below those before, so they may be larger than they need be. Each level's samples must
/// be means of the finest ones that lie in them.
std::vector<TileBounds> measure_tile_bounds(const TileTree& tree,
                                            const std::function<ReadSamples()>& make_reader,
                                            const std::function<bool(double)>& told = {},
                                            const BoundsBefore* before = nullptr);

}  // namespace talus
