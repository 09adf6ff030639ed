// How exactly the rays of a cell are marched (Ammann, Génevaux & Dischler 2010, section 4.2): 0 most, 1 least.
//   L = min(d, d_max) / d_max - h cos(theta)
//   centre_m       of the cell's box, from the eye; its distance is d, and theta its angle with the vertical
//   height_share   h, the box's height over the terrain's relief
//   range_m        d_max, from which on distance takes no more precision
real cell_precision(real3 centre_m, real height_share, real range_m) {
    real distance_m = sqrt(centre_m.x * centre_m.x + centre_m.y * centre_m.y + centre_m.z * centre_m.z);
    real cosine = abs(centre_m.z) / max(distance_m, real(1e-20));
    return min(max(min(distance_m, range_m) / range_m - height_share * cosine, real(0)), real(1));
}

// Which of `levels` equal parts of 0 to 1 that is in.
int precision_level(real least, int levels) { return min(int(least * real(levels)), levels - 1); }
