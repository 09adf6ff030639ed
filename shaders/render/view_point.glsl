// What the files of shaders/render/views have at hand. The including side has surface.glsl and relief.glsl.
const float pi = 3.14159265;

// What a view colours: a point of the ground in the picture.
struct ViewPoint {
    vec2 hit;         // distance along the ray, m, and the method's detail
    vec2 at;          // in the picture, -1 to 1
    vec2 place;       // columns and rows from the origin cell
    vec2 absolute;    // and from the first sample
    vec3 ray;         // in columns, rows and metres
    vec3 world_ray;   // east, north, up
    bool missed;
    float distance_m;
    float above_eye_m;
    float height_m;
    float lowest_m;   // of the terrain, over the eye
    float highest_m;
    float share;      // of the way from lowest to highest
    Relief relief;
    vec3 normal;
    float lit;        // how bright flat colours are: 0.55 in the shade, 1 towards the sun
};

const vec3 bare = vec3(0.62);  // ground without what the view shows

// A layer at a place of the picture, between its four samples; `ghosts` samples lie around it.
vec4 layer_at(sampler2D layer, vec2 place, int ghosts) {
    ivec2 cell = clamp(origin_cell + ivec2(floor(place)), ivec2(0), patches - 1);
    vec2 w = clamp(place - vec2(cell - origin_cell), 0.0, 1.0);
    vec4 sum = vec4(0.0);
    for (int i = 0; i < 4; ++i)
        sum += ((i & 1) == 0 ? 1.0 - w.x : w.x) * (i < 2 ? 1.0 - w.y : w.y) * texelFetch(layer, cell + ivec2(i & 1, i >> 1) + ghosts, 0);
    return sum;
}
