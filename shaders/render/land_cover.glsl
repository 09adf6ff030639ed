// The colour of a number of the land cover, bare where the parameters hold. The including side has colour_map().

// `number`: it times its share, and its share.
vec3 land_cover_colour(vec2 number, float scale) {
    return number.y > 0.0 ? mix(bare, colour_map(number.x / (number.y * scale)), min(number.y, 1.0)) : bare;
}

// The number itself; 0 where the parameters hold.
float land_cover_value(vec2 number) { return number.y > 0.0 ? number.x / number.y : 0.0; }
