// The point of a patch that the pixel's ray meets: the triangles say which patch, its quadratic says where.
#include "maths/glsl_types.glsl"
#include "render/picture.glsl"
#include "maths/patch.glsl"
#ifdef BEHIND_RAYS
#include "render/hybrid_sectors.glsl"
#endif

layout(location = 0) out vec2 hit_out;

flat in vec4 corners;
flat in ivec2 offset;

uniform real2 origin_fraction;
uniform real2 cell_m;
uniform real pixel_m;

void main() {
    real2 picture_at = picture_position();
    real3 way = ray_forward + picture_at.x * ray_right + picture_at.y * ray_up;
    // In depth along the view: where the ray meets the triangle, then on to the patch below it.
    real depth = 1.0 / gl_FragCoord.w;
    real3 ray = real3(way.x * cells_per_m.x, -way.y * cells_per_m.y, way.z);
    real2 at = (origin_fraction - real2(offset)) + depth * ray.xy;
    real b = corners.y - corners.x;
    real c = corners.z - corners.x;
    real a = (corners.w - corners.z) - b;
    real c0 = ray.z * depth - (corners.x + b * at.x + (c + a * at.x) * at.y);
    real c1 = ray.z - ((b + a * at.y) * ray.x + (c + a * at.x) * ray.y);
    real c2 = -a * (ray.x * ray.y);
    real discriminant = c1 * c1 - 4.0 * c2 * c0;
    real root = sqrt(max(discriminant, 0.0));
    // The first crossing downwards, of the two equal forms the one that does not cancel; the triangle itself where the ray
    // is below the patch there and never was above.
    bool below = c0 <= 0.0 && (c1 >= 0.0 || discriminant < 0.0);
    real s = below ? 0.0 : c1 < 0.0 ? 2.0 * c0 / (root - c1) : (c1 + root) / max(-2.0 * c2, 1e-30);
    // Corners snap to 1/256 pixel, so a ray over the edge between two patches may be given to the wrong one: 1/64 pixel of
    // ground beside a patch belongs to it, and a ray that leaves it less than 1/64 pixel above, or is below it where it
    // enters, hits the edge.
    real given = depth * pixel_m * real(1.0 / 64.0);
    real2 inverse = 1.0 / max(abs(ray.xy), 1e-20);
    real2 from_middle = sign(ray.xy) * (at - 0.5);
    real2 half_patch = 0.5 + given * cells_per_m;
    real2 ahead = (half_patch - from_middle) * inverse;
    real2 back = (half_patch + from_middle) * inverse;
    real leave = min(ahead.x, ahead.y);
    real enter = -min(back.x, back.y);
    bool over = s > leave && c0 + leave * (c1 + c2 * leave) > given;
    if (over || discriminant < 0.0 && !below) discard;
    real hit = depth + max(min(s, leave), enter);
    real distance = hit * length(way);
#ifdef BEHIND_RAYS
    if (hit * length(way.xy) >= uintBitsToFloat(reach_m[int(sector_of(way.xy)) % sector_count])) discard;
#endif
    hit_out = vec2(distance, 1.0);  // one step, and kind 1
}
