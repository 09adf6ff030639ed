// The terrain's sides, six vertices a patch of its edge: from the surface down without end, since the ground is solid.
// north, south, west, east one after the other; from inside they wind clockwise and are not drawn.
#include "render/surface.glsl"
#include "render/camera.glsl"

uniform real near_m;

void main() {
    int segment = gl_VertexID / 6;
    int k = gl_VertexID % 6;
    bool left = k == 0 || k == 3 || k == 5;
    bool bottom = k < 2 || k == 3;
    int2 at;
    if (segment < patches.x)
        at = int2(segment + (left ? 1 : 0), 0);
    else if ((segment -= patches.x) < patches.x)
        at = int2(segment + (left ? 0 : 1), patches.y);
    else if ((segment -= patches.x) < patches.y)
        at = int2(0, segment + (left ? 0 : 1));
    else
        at = int2(patches.x, segment - patches.y + (left ? 1 : 0));
    real2 place = (real2(at - origin_cell) - origin_fraction) * cell_m;
    real height = (texelFetch(ground, at, 0).r - origin_height_m.x) - origin_height_m.y;
    // Below, a point at infinity: a direction.
    real3 clip = clip_of(bottom ? real3(0.0, 0.0, -1.0) : real3(place.x, -place.y, height));
    gl_Position = vec4(clip.xy, bottom ? 0.0 : near_m, clip.z);
}
