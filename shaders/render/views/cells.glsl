// What drew each pixel: mesh or ray (render/methods/method.h); of terrain in tiles, the level of its tile.

vec3 view_colour(ViewPoint point) {
#ifdef TILED
    vec3 kind = colour_map(float(relief_tile.level) / float(max(tile_top_level, 1)));
#else
    vec3 kind = kind_map(point.hit.y);
#endif
    return kind * (0.45 + 0.55 * max(dot(point.normal, sun), 0.0));
}
