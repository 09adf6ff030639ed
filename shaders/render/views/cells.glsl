// What drew each pixel: mesh or ray (render/methods/method.h).

vec3 view_colour(ViewPoint point) { return kind_map(point.hit.y) * (0.45 + 0.55 * max(dot(point.normal, sun), 0.0)); }
