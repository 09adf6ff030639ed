// How far around the eye the mesh reaches: by sectors of direction, the distance over ground of the nearest cell that
// rays draw. A pixel whose patch lies nearer than that can have no such cell in front of it.
#include "render/sector_count.glsl"

// Bits of floats above 0 order as they do. One shader finds them, the others read them.
#ifdef MAKES_MESH_CELLS
layout(std430) coherent buffer Reach { uint reach_m[]; };
#else
layout(std430) readonly buffer Reach { uint reach_m[]; };
#endif

// From 0 to sector_count around the circle, growing with the angle from west over south: the diamond's angle, which
// takes one division.
real sector_of(real2 way) {
    real share = way.y / max(abs(way.x) + abs(way.y), 1e-30);
    return real(sector_count) * 0.25 * (way.x < 0.0 ? (way.y < 0.0 ? -share : 4.0 - share) : 2.0 + share);
}

// The sectors of a rectangle over ground, first and count, with one more on either side for rounding; all of them where
// the eye stands in it.
int2 sectors_of(real2 low, real2 high) {
    if (low.x <= 0.0 && high.x >= 0.0 && low.y <= 0.0 && high.y >= 0.0) return int2(0, sector_count);
    real first = sector_of(low);
    real least = 0.0;
    real most = 0.0;
    for (int i = 1; i < 4; ++i) {
        real off = sector_of(real2((i & 1) == 0 ? low.x : high.x, (i & 2) == 0 ? low.y : high.y)) - first;
        // The short way around.
        off -= real(sector_count) * floor(off / real(sector_count) + 0.5);
        least = min(least, off);
        most = max(most, off);
    }
    int from = int(floor(first + least)) - 1;
    int count = int(floor(first + most)) + 2 - from;
    return int2((from + 2 * sector_count) % sector_count, min(count, sector_count));
}

// Least and greatest reach over sectors.
real2 reach_over(int2 sectors) {
    real least = uintBitsToFloat(0x7f800000u);
    real most = 0.0;
    for (int i = 0; i < sectors.y; ++i) {
        real reach = uintBitsToFloat(reach_m[(sectors.x + i) % sector_count]);
        least = min(least, reach);
        most = max(most, reach);
    }
    return real2(least, most);
}

// The depth along the view up to which the mesh shows all ground, for a bundle of rays.
real free_depth(real2 way, real2 spread) {
    int2 sectors = sectors_of(way - spread, way + spread);
    if (sectors.y > 64) return 0.0;
    return min(reach_over(sectors).x, 1e9) / length(abs(way) + spread);
}
