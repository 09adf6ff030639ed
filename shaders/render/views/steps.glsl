// How many cells each ray visited, the sky's too.
uniform real steps_scale;

vec3 view_colour(ViewPoint point) { return colour_map(point.hit.y / steps_scale); }
