// A cell of the pyramid as a box before the eye. The including side has surface.glsl and camera.glsl.

uniform sampler2D bottoms;

// The cell's box, metres from the eye: east, north, up. Its footprint ends with the terrain.
struct CellBox {
    real3 low;
    real3 high;
};

// Over patches from first to before last, between bounds over the eye.
CellBox box_over(int2 first, int2 last, real2 bounds_m) {
    real2 west_north = (real2(first - origin_cell) - origin_fraction) * cell_m;
    real2 east_south = (real2(last - origin_cell) - origin_fraction) * cell_m;
    CellBox box;
    box.low = real3(west_north.x, -east_south.y, bounds_m.x);
    box.high = real3(east_south.x, -west_north.y, bounds_m.y);
    return box;
}

CellBox cell_box(int2 cell, int level) {
    int2 texel = pyramid_texel(cell, level);
    real2 bounds_m = (real2(texelFetch(bottoms, texel, 0).r, texelFetch(tops, texel, 0).r) - origin_height_m.x) - origin_height_m.y;
    return box_over(cell << level, min((cell + 1) << level, patches), bounds_m);
}

real3 box_corner(CellBox box, int i) {
    return real3((i & 1) == 0 ? box.low.x : box.high.x, (i & 2) == 0 ? box.low.y : box.high.y, (i & 4) == 0 ? box.low.z : box.high.z);
}

// True when the box may be seen in the picture: no plane of the view has all corners outside.
bool box_in_view(CellBox box) {
    int outside = 31;
    for (int i = 0; i < 8; ++i) {
        real3 clip = clip_of(box_corner(box, i));
        int here = 0;
        if (clip.x > clip.z) here |= 1;
        if (clip.x < -clip.z) here |= 2;
        if (clip.y > clip.z) here |= 4;
        if (clip.y < -clip.z) here |= 8;
        if (clip.z < 0.0) here |= 16;
        outside &= here;
    }
    return outside == 0;
}
