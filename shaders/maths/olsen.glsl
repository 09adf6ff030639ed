// Thermal erosion as Olsen 2004 describes it ("Realtime procedural terrain generation", section on thermal erosion; erosion of
// Ammann et al. 2010, figure 10), to compare with maths/thermal.glsl: height differences to single neighbours decide, and not
// the gradient. All samples give at once, where his loop goes from sample to sample. The including side has maths/thermal.glsl
// before this, and gives
//   is_sample(int2)   bool: not beside the terrain
//   only_lowest       bool: his faster variant: the four diagonal neighbours, of which the lowest takes all

// Pairs k and k ^ 1 are opposite: along the axes, then along the diagonals.
int2 olsen_neighbour(int2 at, int k) {
    int step = (k & 1) == 0 ? 1 : -1;
    int2 offset = k < 2 ? int2(step, 0) : (k < 4 ? int2(0, step) : (k < 6 ? int2(step, step) : int2(step, -step)));
    return int2(at.x + offset.x, at.y + offset.y);
}

// Metres that a sample lies above a neighbour; beside the terrain there is none.
real olsen_drop(int2 at, real4 here, int k) {
    int2 there = olsen_neighbour(at, k);
    return is_sample(there) ? rise(load_solid(there), here) : real(0);
}

// Metres of solid that a sample gives to a neighbour: of half the largest drop beyond the threshold, a part as its drop is of
// all that are beyond. A threshold of height, the same for all neighbours: the angle of repose along the axes.
real olsen_given(int2 at, int k) {
    real4 here = load_solid(at);
    real threshold = load_repose(at) * min(cell_m.x, cell_m.y);
    real drop = olsen_drop(at, here, k);
    if (!(drop > threshold)) return real(0);
    real largest = real(0);
    real all = real(0);
    bool lowest = true;
    for (int j = only_lowest ? 4 : 0; j < 8; ++j) {
        real other = olsen_drop(at, here, j);
        if (!(other > threshold)) continue;
        precise real sum = all + other;
        all = sum;
        largest = max(largest, other);
        lowest = lowest && (other < drop || (other == drop && j >= k));
    }
    if (only_lowest && !lowest) return real(0);
    precise real beyond = real(0.5) * (largest - threshold);
    precise real part = beyond * (drop / all);
    real mask = min(load_mask(at), load_mask(olsen_neighbour(at, k)));
    precise real given = (only_lowest ? beyond : part) * mask;
    return given;
}

// The sample after one sub-step.
real4 olsen_sample(int2 at) {
    real gain = real(0);
    real loss = real(0);
    for (int k = only_lowest ? 4 : 0; k < 8; ++k) {
        int2 there = olsen_neighbour(at, k);
        if (!is_sample(there)) continue;
        precise real gained = gain + olsen_given(there, k ^ 1);
        precise real lost = loss + olsen_given(at, k);
        gain = gained;
        loss = lost;
    }
    return weathered(exchange_solid(load_solid(at), gain, loss, thermal_bulking), load_mask(at));
}
