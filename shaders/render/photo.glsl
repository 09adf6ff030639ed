// A photo in tiles over the ground (render/tiled/photo_surface.h), filtered over the footprint of a pixel (Dick, Krueger &
// Westermann 2009, section 3.3): of the tile that is shown there, its finest texels or smaller pictures of them.
#include "render/tile_nodes.glsl"

uniform sampler2D photo_texels;  // slots of tiles; linear colours times what is covered, and that
uniform sampler2D photo_nodes;   // as tile_nodes of tile_surface.glsl
uniform sampler2D photo_places;  // a row a slot: the eye among its texels, its texels for a finest one; its first and its last corner
uniform vec2 photo_eye;          // among the finest texels
uniform vec2 photo_scale;        // finest texels for a column and a row of the ground
uniform ivec2 photo_patches;
uniform int photo_side_level;
uniform int photo_top_level;
uniform int photo_rows;
uniform float photo_widest;      // texel of the smallest picture, in those of the slot

float photo_slot(ivec2 patch_at, int level) {
    return texelFetch(photo_nodes, tile_node_texel(patch_at >> (photo_side_level + level), level, photo_rows), 0).g;
}

// from_eye: columns and rows of the ground; likewise the footprint. Nothing lies beside the photo.
vec4 photo_at(vec2 from_eye, Footprint footprint) {
    vec2 finest = photo_eye + from_eye * photo_scale;
    ivec2 patch_at = clamp(ivec2(floor(finest)), ivec2(0), photo_patches - 1);
    // The level that a pixel can tell is near the one that is shown.
    int level = clamp(int(log2(max(footprint_texel(footprint.right * photo_scale, footprint.up * photo_scale), 1.0))), 0, photo_top_level);
    float slot = photo_slot(patch_at, level);
    // Within a tile that is shown, or above four that are.
    while (slot < -1.5 && level < photo_top_level) {
        level += 1;
        slot = photo_slot(patch_at, level);
    }
    while (slot > -1.5 && slot < -0.5 && level > 0) {
        level -= 1;
        slot = photo_slot(patch_at, level);
    }
    vec4 eye = texelFetch(photo_places, ivec2(0, int(slot)), 0);
    vec4 held = texelFetch(photo_places, ivec2(1, int(slot)), 0);
    vec2 size = vec2(textureSize(photo_texels, 0));
    vec2 texels = photo_scale * eye.zw;
    // Half a texel of the smallest picture that is looked at lies between the taps and the neighbouring slot.
    float widest = footprint_texel(footprint.right * texels, footprint.up * texels);
    float inset = 0.5 * exp2(ceil(log2(clamp(widest, 1.0, photo_widest))));
    footprint.right *= texels / size;
    footprint.up *= texels / size;
    vec4 colour = filtered_along(photo_texels, (eye.xy + from_eye * texels) / size, footprint, (held.xy + inset) / size, (held.zw - inset) / size);
#ifdef PHOTO_COVERS
    return colour;
#endif
    bool beside = any(lessThan(finest, vec2(-0.5))) || any(greaterThan(finest, vec2(photo_patches) + 0.5));
    return beside ? vec4(0.0) : colour;
}
