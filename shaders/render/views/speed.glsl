// The water's speed, with streaks along it.
uniform real speed_scale;  // m/s
#include "render/flow.glsl"

// Streaks along the flow: noise smeared along it (line integral convolution, Cabral & Leedom 1993), about 1.
float streaks(vec2 place, vec2 velocity) {
    vec2 along = vec2(velocity.x, -velocity.y) / max(length(velocity), 1e-6);
    float sum = 0.0;
    for (int k = -10; k <= 10; ++k) sum += textureLod(grain, (place + 0.5 * float(k) * along) * (1.0 / 56.0), 0.0).z;
    return clamp(1.0 + 2.2 * (sum / 21.0 - 0.5), 0.6, 1.4);
}

float view_value(vec2 place) { return length(flow_at(place).velocity); }

vec3 view_colour(ViewPoint point) {
    Flow flow = flow_at(point.place);
    if (flow.depth_m < wet_depth_m) return bare * point.lit;
    float speed = length(flow.velocity);
    return colour_map(speed / speed_scale) * (speed > 1e-3 * speed_scale ? streaks(point.absolute, flow.velocity) : 1.0);
}
