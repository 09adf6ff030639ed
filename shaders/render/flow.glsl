// The water at a place of the picture, between its four samples. The including side has surface.glsl.
#include "sim/water_layout.glsl"
uniform sampler2D water;  // depth, its low word, discharge east and north; two ghost samples around

struct Flow {
    float depth_m;
    vec2 velocity;  // m/s, east and north; none in water too thin to see
};

// place: columns and rows from the origin cell.
Flow flow_at(vec2 place) {
    ivec2 cell = clamp(origin_cell + ivec2(floor(place)), ivec2(0), patches - 1);
    vec2 w = clamp(place - vec2(cell - origin_cell), 0.0, 1.0);
    vec3 sum = vec3(0.0);
    for (int i = 0; i < 4; ++i) {
        vec4 texel = texelFetch(water, cell + ivec2(i & 1, i >> 1) + water_ghosts, 0);
        sum += ((i & 1) == 0 ? 1.0 - w.x : w.x) * (i < 2 ? 1.0 - w.y : w.y) * texel.xzw;
    }
    Flow flow;
    flow.depth_m = sum.x;
    flow.velocity = sum.x < wet_depth_m ? vec2(0.0) : sum.yz / sum.x;
    return flow;
}
