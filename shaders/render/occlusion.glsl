// How much of the sky's light a place gets past the ground around it (render/sky_view.h). place: absolute columns and rows.
#ifdef OCCLUSION
uniform sampler2D sky_share;

float sky_share_at(vec2 place) {
    vec2 at = 0.25 * place - 0.5;
    ivec2 first = ivec2(floor(at));
    vec2 w = at - vec2(first);
    ivec2 last = textureSize(sky_share, 0) - 1;
    ivec2 low = clamp(first, ivec2(0), last);
    ivec2 high = clamp(first + 1, ivec2(0), last);
    float above = mix(texelFetch(sky_share, low, 0).r, texelFetch(sky_share, ivec2(high.x, low.y), 0).r, w.x);
    float below = mix(texelFetch(sky_share, ivec2(low.x, high.y), 0).r, texelFetch(sky_share, high, 0).r, w.x);
    return mix(above, below, w.y);
}
#else
float sky_share_at(vec2 place) { return 1.0; }
#endif
