// Samples of one block of the terrain along a ray, as far apart as the terrain's own (Jeong & Han 2006, sections 3 and 4). What
// lies between two samples is missed, and the hit lies on the line between the last two. The including side has maths/cast.glsl
// and maths/march.glsl before this.

// first, last: the block's planes between columns and rows; top_m: the highest sample of the terrain, over the origin height;
// relief_m: from there to the lowest; from_m: nothing is met before. Samples are counted from where the ray comes over the
// block, so that a hit does not depend on from_m. Other parameters as in maths/cast.glsl.
CastHit sample_block(int2 first, int2 last, real top_m, real relief_m, real from_m, int2 origin_cell, real2 fraction, real3 direction) {
    CastHit hit;
    hit.distance_m = real(-1);
    hit.steps = 0;
    real2 inverse = real2(cast_inverse(direction.x), cast_inverse(direction.y));
    real inverse_z = cast_inverse(direction.z);
    int2 side = int2(direction.x < real(0) ? 0 : 1, direction.y < real(0) ? 0 : 1);
    real2 span = cast_span(first, last, top_m, origin_cell, fraction, direction, inverse, inverse_z, side);
    if (span.x > span.y || from_m > span.y) return hit;
    // A column or row apart; of steep rays as far as the ground can lie below a sample that is above it.
    real spacing = min(min(abs(inverse.x), abs(inverse.y)), relief_m * abs(inverse_z));
    int number = max(int(floor((from_m - span.x) / spacing)), 0);
    real at = min(span.x + real(number) * spacing, span.y);
    real above = march_above(origin_cell, fraction, direction, at);
    hit.steps = 1;
    if (above <= real(0) && number > 0) {
        // Rounding put the start a sample too far.
        number -= 1;
        at = span.x + real(number) * spacing;
        above = march_above(origin_cell, fraction, direction, at);
        hit.steps += 1;
    }
    if (above <= real(0)) {
        hit.distance_m = at;
        return hit;
    }
    // Across the block there are nine at most, and of rays that hardly get further two down to the lowest ground. The number stops a
    // loop that rounding might make endless.
    while (at < span.y && hit.steps < 64) {
        number += 1;
        real next = min(span.x + real(number) * spacing, span.y);
        real above_next = march_above(origin_cell, fraction, direction, next);
        hit.steps += 1;
        if (above_next <= real(0)) {
            hit.distance_m = at + (next - at) * (above / (above - above_next));
            return hit;
        }
        at = next;
        above = above_next;
    }
    return hit;
}
