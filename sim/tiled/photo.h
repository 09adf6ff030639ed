#pragma once
#include <cstdint>
#include <functional>
#include <vector>

#include "sim/tiled/heights_between.h"

namespace talus {

/// A texel of a photo. Its colour, as screens take it, is that of the linear colour times the share `a` of
/// the texel that the photo covers.
struct PhotoTexel {
    std::uint8_t r = 0;
    std::uint8_t g = 0;
    std::uint8_t b = 0;
    std::uint8_t a = 0;  ///< 255: all of it
    bool operator==(const PhotoTexel&) const = default;
};

/// Reads texels of a photo's level, row by row: `count` from the `first` one on. Texels beside the level are
/// those of its edge. Throws talus::Error where they cannot be read.
using ReadTexels =
    std::function<void(int level, const TileSamples& samples, std::vector<PhotoTexel>& texels)>;

/// Where a photo lies over a ground: the place among its finest texels, counted from the middle of the first
/// one, is first + scale * (column, row) of the ground.
struct PhotoPlace {
    glm::dvec2 first{0};
    glm::dvec2 scale{1};
};

/// Sizes of a photo's levels and how tiles cut it up. Its metres are those of the ground that it lies over.
TileTree photo_tree(glm::ivec2 texels, const Grid& ground, const PhotoPlace& place);

/// What is known of its tiles: between which heights the ground under each lies, and, as the error that tiles
/// are chosen by, how wide its texels are. Where no ground lies, nothing is ever off.
std::vector<TileBounds> photo_bounds(const TileTree& tree, const PhotoPlace& place,
                                     const HeightsBetween& heights);

/// A reader that gives, behind the texels, `halvings` smaller pictures of them, each the means of 2 x 2 of
/// the one before, as light adds up. Both sides must be multiples of two so many times.
ReadTexels with_smaller_pictures(ReadTexels read, int halvings);

}  // namespace talus
