// One dab of a brush on one sample. The including side gives real4 load_solid(int2), repeating the edge, and
//   cell_m          real2, spacing, metres
//   dab_sample      int2, the sample at or before the dab's centre (column, row)
//   dab_offset      real2, the centre's offset from that sample in spacings, 0 to 1
//   dab_radius_m    real
//   dab_falloff     real, 0 (hard edge) to 1 (soft all the way): the share of the radius over which it fades
//   dab_mode        int, 0 raise, 1 lower, 2 smooth, 3 flatten
//   dab_amount_m    real, raise and lower: metres at full weight
//   dab_blend       real, smooth and flatten: share of the way at full weight, 0 to 1
//   dab_target_m    real2, flatten: the height to reach, two words
//   dab_on_regolith int, 1: raise adds regolith rather than bedrock
#include "maths/brush_weight.glsl"
#include "maths/solid.glsl"

// Metres that the dab adds to the ground at the sample.
real brush_change(int2 at, real4 c) {
    real weight = brush_weight_at(at);
    precise real change = weight * dab_amount_m;
    if (dab_mode == 1) change = -change;
    if (dab_mode == 2) {
        // Half way to the four neighbours at most, each axis by the inverse square of its spacing: isotropic, stable.
        precise real xx = cell_m.x * cell_m.x;
        precise real yy = cell_m.y * cell_m.y;
        precise real rises_x = rise(c, load_solid(at + int2(1, 0))) + rise(c, load_solid(at + int2(-1, 0)));
        precise real rises_y = rise(c, load_solid(at + int2(0, 1))) + rise(c, load_solid(at + int2(0, -1)));
        precise real mean = (rises_x * yy + rises_y * xx) / (real(2) * (xx + yy));
        change = (weight * dab_blend) * mean;
    }
    if (dab_mode == 3) {
        real to_target = rise(c, real4(dab_target_m.x, dab_target_m.y, real(0), real(0)));
        change = (weight * dab_blend) * to_target;
    }
    return change;
}

// The sample after `change` metres of ground: what is added is bedrock or regolith, what is taken regolith first.
real4 brush_sample(real4 c, real change) {
    if (change > real(0) && dab_on_regolith == 0) {
        real2 bedrock = add_increment(real2(c.x, c.y), change);
        return real4(bedrock.x, bedrock.y, c.z, c.w);
    }
    return exchange_solid(c, max(change, real(0)), max(-change, real(0)), real(1));
}
