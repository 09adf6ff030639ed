// Wear and deposition at a place of the picture. The including side has layer_at().
uniform sampler2D layer;  // by water: wear, deposition, m, two words each
uniform sampler2D second_layer;  // by slopes
uniform sampler2D third_layer;   // by hand
uniform int layers_there;        // a bit for each
uniform real worn_by;            // 0: all together; else one of them, from 1
uniform real worn_scale_m;       // end of the scale

vec2 worn_at(vec2 place) {
    int shown = worn_by > 0.0 ? layers_there & (1 << int(worn_by - 1.0)) : layers_there;
    vec4 sum = vec4(0.0);
    if ((shown & 1) != 0) sum += layer_at(layer, place, 0);
    if ((shown & 2) != 0) sum += layer_at(second_layer, place, 0);
    if ((shown & 4) != 0) sum += layer_at(third_layer, place, 0);
    return vec2(sum.x + sum.y, sum.z + sum.w);
}

vec3 worn_colour(float metres, float lit) { return colour_map(metres / worn_scale_m) * lit; }
