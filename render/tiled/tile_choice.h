#pragma once
#include <functional>
#include <vector>

#include "render/camera.h"
#include "sim/tiled/tile_bounds.h"

namespace talus::render {

/// A place in the tree of tiles that a picture is drawn from.
struct TileNode {
    TileId tile;
    int slot = -1;        ///< whose tile is drawn where this one is; -1: the four tiles below it are drawn
    float highest_m = 0;  ///< no ground that is drawn there lies higher
    bool operator==(const TileNode&) const = default;
};

/// What a picture of a tiled terrain is drawn from.
struct TileChoice {
    std::vector<TileNode> nodes;  ///< all but those that lie in a tile that is drawn
    std::vector<TileId> wanted;   ///< asked for and not on the device; the worst first, by
                                  ///< what would be drawn if nothing finer were there
    std::vector<TileId> drawn;    ///< on the device; one may be drawn in several places, instead of others
    std::vector<TileId> needed;   ///< of these, the ones that the picture asked for
    double tolerance_px = 0;      ///< so many pixels off are tiles at most when all that are wanted are there
};

/// Chooses the coarsest tiles whose distance from the finest surface projects to at most tolerance_px
/// anywhere in the tile (Dick, Krüger & Westermann 2009, section 4, with measured bounds), for a picture of
/// `size` pixels. Where more than `room` tiles would be needed, the tolerance is coarsened until they are no
/// more. slot_of: the slot that a tile is in, or -1. Tiles of the coarsest level must be in one.
TileChoice choose_tiles(const TileTree& tree, const std::vector<TileBounds>& bounds, const Camera& camera,
                        glm::ivec2 size, double tolerance_px, std::size_t room,
                        const std::function<int(const TileId&)>& slot_of);

}  // namespace talus::render
