// A beam of the rays of beam_pixels x beam_pixels pixels. Writes the depth along the view up to which none meets ground,
// and the level of the pyramid to go on from; level 0: no ray meets ground at all. A flat end instead writes the height
// at which all rays end, and minus the level of its cells. A level carries a note for its rays in its fraction. BEAM_FILE names the file of the ground: whole_beam.glsl or
// tile_beam.glsl.
#include "render/camera.glsl"
#include BEAM_FILE
#include "render/beam_pixels.glsl"
#ifdef FLAT_ENDS
const bool flat_ends = true;
#else
const bool flat_ends = false;
#endif
#include "maths/beam.glsl"
#ifdef BEHIND_MESH
#include "render/hybrid_list.glsl"
#include "render/hybrid_sectors.glsl"
#endif

layout(location = 0) out vec2 beam_out;

uniform real flatness;

void main() {
    // Corners of the block in the picture, -1 to 1; ways grow linearly, so its middle and half its spread tell all.
    real2 step_size = 2.0 * real(beam_pixels) / picture_size;
    real2 at = (floor(gl_FragCoord.xy) + 0.5) * step_size - 1.0;
    real3 way = ray_forward + at.x * ray_right + at.y * ray_up;
    real3 spread = 1.001 * 0.5 * (step_size.x * abs(ray_right) + step_size.y * abs(ray_up));
    real from = 0.0;
#ifdef BEHIND_MESH
    // Nearer than the mesh reaches it shows all ground, so a ray that passed it starts there.
    if (mesh_is_drawn()) from = free_depth(way.xy, spread.xy);
#endif
    real3 scale = real3(cells_per_m, 1.0);
    real3 middle = real3(way.x * scale.x, -way.y * scale.y, way.z);
    Beam beam = cast_beam(origin_cell, origin_fraction, middle, spread * scale, from, flatness);
    float note = beam.level > 0 ? beam_note(beam.depth, middle) : 0.0;
    beam_out = beam.flat_end ? vec2(beam.height_m, float(-beam.level)) : vec2(beam.depth * real(0.9999), float(beam.level) + note);
}
