// Relief mapping: samples along a ray, evenly spaced until one lies under the surface, then halvings of the last interval
// (Policarpo, Oliveira & Comba 2005, section 3). What lies between two samples is missed where it is thinner than their
// spacing. The including side gives what maths/cast.glsl asks for, and has it before this.

// Height of a point of the ray over the surface; beside the terrain over its nearest border.
real march_above(int2 origin_cell, real2 fraction, real3 direction, real at_m) {
    real2 place = real2(fraction.x + at_m * direction.x, fraction.y + at_m * direction.y);
    int2 cell = int2(origin_cell.x + int(floor(place.x)), origin_cell.y + int(floor(place.y)));
    cell = int2(min(max(cell.x, 0), patches.x - 1), min(max(cell.y, 0), patches.y - 1));
    real2 within = real2(place.x - real(cell.x - origin_cell.x), place.y - real(cell.y - origin_cell.y));
    within = real2(min(max(within.x, real(0)), real(1)), min(max(within.y, real(0)), real(1)));
    return at_m * direction.z - patch_height(load_corners(cell), within);
}

// Between two points of the ray, m along it: the first of `samples` intervals whose end lies under the surface, halved
// `halvings` times. The hit's steps are the samples that were read. The ground is solid: where the ray begins under it, it
// hits. An end before the beginning: the ray meets no ground. Parameters as in maths/cast.glsl.
CastHit march_ray(int2 origin_cell, real2 fraction, real3 direction, real begin_m, real end_m, int samples, int halvings) {
    CastHit hit;
    hit.distance_m = real(-1);
    hit.steps = 0;
    if (begin_m > end_m) return hit;
    real above = begin_m;
    real below = begin_m;
    real spacing = (end_m - begin_m) / real(samples);
    bool found = march_above(origin_cell, fraction, direction, begin_m) <= real(0);
    hit.steps = 1;
    while (!found && hit.steps <= samples) {
        above = below;
        below = hit.steps == samples ? end_m : begin_m + real(hit.steps) * spacing;
        found = march_above(origin_cell, fraction, direction, below) <= real(0);
        hit.steps += 1;
    }
    if (!found) return hit;
    for (int i = 0; i < halvings && above < below; ++i) {
        real middle = real(0.5) * (above + below);
        bool under = march_above(origin_cell, fraction, direction, middle) <= real(0);
        above = under ? above : middle;
        below = under ? middle : below;
        hit.steps += 1;
    }
    hit.distance_m = below;
    return hit;
}

// From where the ray enters a box, or from its start within it, to where it leaves. first, last: the box's planes between
// columns and rows; bounds_m: the lowest and the highest of its samples, over the origin height.
CastHit march_box(int2 first, int2 last, real2 bounds_m, int2 origin_cell, real2 fraction, real3 direction, int samples, int halvings) {
    real2 inverse = real2(cast_inverse(direction.x), cast_inverse(direction.y));
    real inverse_z = cast_inverse(direction.z);
    int2 side = int2(direction.x < real(0) ? 0 : 1, direction.y < real(0) ? 0 : 1);
    real2 span = cast_span(first, last, bounds_m.y, origin_cell, fraction, direction, inverse, inverse_z, side);
    // At the bottom of the box every ray is on the ground or under it, whatever rounding says.
    real bottom = bounds_m.x * inverse_z;
    bool through_bottom = span.x <= span.y && direction.z < real(0) && bottom < span.y;
    real end = through_bottom ? max(bottom, span.x) : span.y;
    CastHit hit = march_ray(origin_cell, fraction, direction, span.x, end, samples, halvings);
    if (through_bottom && hit.distance_m < real(0)) hit.distance_m = end;
    return hit;
}
