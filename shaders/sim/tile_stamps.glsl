// A writer notes what it changed in a tile by a running number. Each reader remembers up to which number it has read, so that no
// writer knows the readers (sim/terrain/tiles.h).
#include "sim/tile_changes.glsl"

layout(std430) buffer TileStamps { uint tile_stamps[]; };  // the last change of each kind, tile after tile
uniform uint stamp_now;

// Invocations of one dispatch write the same number.
void stamp_tile(int tile, uint change) {
    uint first = uint(tile) * tile_kinds;
    if (tile_stamps[first + change] != stamp_now) tile_stamps[first + change] = stamp_now;
    if (tile_stamps[first + tile_any] != stamp_now) tile_stamps[first + tile_any] = stamp_now;
}
