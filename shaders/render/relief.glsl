// The ground around a place of the picture, in columns and rows from the origin cell. The including side has load_corners()
// and maths/patch.glsl, and gives
//   int2 relief_origin()        the origin cell
//   int2 relief_first(), relief_last()   the patches that there are
//   real2 relief_cell_m()       size of a patch

// Height over the eye.
float height_at(vec2 place) {
    ivec2 cell = clamp(relief_origin() + ivec2(floor(place)), relief_first(), relief_last());
    vec2 w = clamp(place - vec2(cell - relief_origin()), 0.0, 1.0);
    return patch_height(load_corners(cell), w);
}

struct Relief {
    vec2 gradient;  // slope to east and north
    float hollow;   // how far the ground around lies above, over its distance: curvature; > 0 in valleys, < 0 on ridges
};

// Over `reach` samples to each side, so that distant ground does not sparkle.
Relief relief_at(vec2 place, float height_m, float reach) {
    vec2 low = vec2(relief_first() - relief_origin());
    vec2 high = vec2(relief_last() + 1 - relief_origin());
    vec2 patch_m = relief_cell_m();
    vec2 west = clamp(place - vec2(reach, 0.0), low, high);
    vec2 east = clamp(place + vec2(reach, 0.0), low, high);
    vec2 north = clamp(place - vec2(0.0, reach), low, high);
    vec2 south = clamp(place + vec2(0.0, reach), low, high);
    vec4 z = vec4(height_at(west), height_at(east), height_at(north), height_at(south));
    Relief relief;
    relief.gradient = vec2((z.y - z.x) / max((east.x - west.x) * patch_m.x, 1e-6), (z.z - z.w) / max((south.y - north.y) * patch_m.y, 1e-6));
    relief.hollow = (0.25 * (z.x + z.y + z.z + z.w) - height_m) / (reach * min(patch_m.x, patch_m.y));
    return relief;
}
