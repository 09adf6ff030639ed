#pragma once
#include "render/tiled/tiled_surface.h"
#include "tests/scenes/memory_tiles.h"

namespace talus::scenes {

/// The coarsest tiles, which a surface must have before it looks at anything.
inline void put_coarsest(render::TiledSurface& surface, const MemoryTiles& tiles) {
    for (const TileId& tile : tiles.tree().coarsest_tiles()) surface.put(tile, tiles.read(tile));
}

/// Looks from a camera until all tiles are there that the picture wants.
inline render::TileChoice load_tiles(render::TiledSurface& surface, const MemoryTiles& tiles,
                                     const render::Camera& camera, glm::ivec2 size, double tolerance_px) {
    for (;;) {
        render::TileChoice choice = surface.look(camera, size, tolerance_px);
        if (choice.wanted.empty()) return choice;
        for (const TileId& tile : choice.wanted) surface.put(tile, tiles.read(tile));
    }
}

}  // namespace talus::scenes
