// The outer mesh of blocks of samples, over the listed tiles: each sample raised to the highest of the 3 x 3 around it, but not those
// that two blocks share (Jeong & Han 2006, section 4). One group a tile.
layout(local_size_x = 64) in;
#include "maths/glsl_types.glsl"
#include "render/envelope.glsl"
#include "sim/tile_samples.glsl"

layout(std430) readonly buffer TileList { uint list_arguments[4]; uint listed_tiles[]; };
layout(std430) buffer EnvelopeVersions { float versions[]; };
uniform sampler2D ground;
layout(r32f) uniform writeonly image2D envelope;

uniform int2 tiles;
uniform int2 patches;

real raised(int2 at) {
    real own = texelFetch(ground, at, 0).r;
    bvec2 shared_side = equal(at % envelope_patches, int2(0));
    if (any(shared_side) || any(equal(at, patches))) return own;
    for (int y = -1; y <= 1; ++y)
        for (int x = -1; x <= 1; ++x) own = max(own, texelFetch(ground, at + int2(x, y), 0).r);
    return own;
}

void main() {
    int tile = int(listed_tiles[gl_WorkGroupID.y]);
    if (gl_LocalInvocationIndex == 0u) versions[tile] = versions[tile] < 16777215.0 ? versions[tile] + 1.0 : 1.0;
    int2 first = int2(tile % tiles.x, tile / tiles.x) * tile_samples;
    int2 size = min(patches + 1 - first, int2(tile_samples));
    for (int i = int(gl_LocalInvocationIndex); i < size.x * size.y; i += 64) {
        int2 at = first + int2(i % size.x, i / size.x);
        imageStore(envelope, at, vec4(raised(at)));
    }
}
