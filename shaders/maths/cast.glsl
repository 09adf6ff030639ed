// Casts a ray onto the whole terrain (docs/numerics.md, "Exact casting"). The including side gives, besides what
// maths/cast_walk.glsl needs,
//   real load_highest()   highest sample of all, over the origin height
//   patches     int2, number of patches (columns - 1, rows - 1)
//   top_level   int, the coarsest level of the pyramid
#include "maths/cast_walk.glsl"

// The first hit of a ray; parameters as there.
// The ground is solid: a ray that starts below it, or enters its side below it, hits there.
CastHit cast_ray(int2 origin_cell, real2 fraction, real3 direction, real from_m, int start_level, real height_m) {
    real2 inverse = real2(cast_inverse(direction.x), cast_inverse(direction.y));
    real inverse_z = cast_inverse(direction.z);
    // 1 where the ray runs towards higher indices: the offset from a cell to its far plane.
    int2 side = int2(direction.x < real(0) ? 0 : 1, direction.y < real(0) ? 0 : 1);
    real2 span = cast_span(int2(0, 0), patches, load_highest() - height_m, origin_cell, fraction, direction, inverse, inverse_z, side);
    return cast_walk(span.x, span.y, origin_cell, fraction, direction, inverse, inverse_z, side, patches, top_level, from_m, start_level, height_m);
}
