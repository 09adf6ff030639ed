// Chooses how each cell is drawn (Ammann, Génevaux & Dischler 2010, section 4.2).
layout(local_size_x = 64) in;
#include "render/surface.glsl"
#include "render/camera.glsl"
#include "render/cell_grid.glsl"
#include "render/cell_box.glsl"
#include "render/ammann_box.glsl"
#include "render/ammann_choices.glsl"
#include "maths/cell_precision.glsl"

layout(std430) writeonly buffer Choices { uint choices[]; };

uniform real mesh_from_px;  // T: pixels a sample
uniform real range;         // k
uniform int levels;
uniform real near_m;

uint choice(CellBox box) {
    if (!box_in_view(box)) return not_drawn;
    real2 low = real2(1e30);
    real2 high = real2(-1e30);
    for (int i = 0; i < 8; ++i) {
        real3 clip = clip_of(box_corner(box, i));
        if (clip.z <= near_m) return by_mesh;
        low = min(low, clip.xy / clip.z);
        high = max(high, clip.xy / clip.z);
    }
    real2 size_px = 0.5 * picture_size * (high - low);
    // The paper divides by the samples of a whole cell; one that the terrain's edge cuts has as many as its share of it.
    real2 samples = (box.high.xy - box.low.xy) / cell_m;
    if (size_px.x * size_px.y > mesh_from_px * samples.x * samples.y) return by_mesh;
    real relief_m = load_highest() - ((texelFetch(bottoms, whole_texel(), 0).r - origin_height_m.x) - origin_height_m.y);
    real diagonal_m = length(real3(real2(patches) * cell_m, relief_m));
    real share = relief_m > 0.0 ? (box.high.z - box.low.z) / relief_m : 0.0;
    real precision_here = cell_precision(0.5 * (box.low + box.high), share, range * diagonal_m);
    return by_rays + uint(precision_level(precision_here, levels));
}

void main() {
    int number = int(gl_GlobalInvocationID.x);
    if (number < cell_count.x * cell_count.y) choices[number] = choice(ammann_box(cell_at(number)));
}
