// Gradient noise on the plane, its sums, and the shapes that terrain is made of. Whole numbers and + - * / sqrt floor:
// the same bits on every machine.

// A well-mixed hash of a lattice point (Jarzynski & Olano 2020, "Hash functions for GPU rendering", pcg3d).
uint noise_hash(uint x, uint y, uint z) {
    x = x * 1664525u + 1013904223u;
    y = y * 1664525u + 1013904223u;
    z = z * 1664525u + 1013904223u;
    x += y * z;
    y += z * x;
    z += x * y;
    x ^= x >> 16u;
    y ^= y >> 16u;
    z ^= z >> 16u;
    x += y * z;
    y += z * x;
    z += x * y;
    return z ^ (x >> 3u);
}

// How the lattice point `corner` slopes at the offset from it: its gradient lies on the unit circle, a direction from a
// point of the square, without sine or cosine.
real noise_slope(int2 corner, real2 offset, uint seed) {
    uint bits = noise_hash(uint(corner.x), uint(corner.y), seed);
    precise real x = real(bits & 0xffffu) * (real(2) / real(65535)) - real(1);
    precise real y = real(bits >> 16u) * (real(2) / real(65535)) - real(1);
    precise real square = x * x + y * y;
    precise real length = sqrt(square) + real(1e-9);
    precise real slope = (x * offset.x + y * offset.y) / length;
    return slope;
}

real noise_blend(real t) {
    precise real blend = t * t * t * (t * (t * real(6) - real(15)) + real(10));
    return blend;
}

// Gradient noise (Perlin 2002, "Improving noise": quintic blend), about -0.7 to 0.7.
real gradient_noise(real2 p, uint seed) {
    real column = floor(p.x);
    real row = floor(p.y);
    int2 cell = int2(int(column), int(row));
    precise real x = p.x - column;
    precise real y = p.y - row;
    real u = noise_blend(x);
    real v = noise_blend(y);
    precise real x1 = x - real(1);
    precise real y1 = y - real(1);
    real a = noise_slope(cell, real2(x, y), seed);
    real b = noise_slope(cell + int2(1, 0), real2(x1, y), seed);
    real c = noise_slope(cell + int2(0, 1), real2(x, y1), seed);
    real d = noise_slope(cell + int2(1, 1), real2(x1, y1), seed);
    precise real top = a + u * (b - a);
    precise real bottom = c + u * (d - c);
    precise real value = top + v * (bottom - top);
    return value;
}

// Octaves turn by atan(3/4), so that the lattice shows in none of the directions.
real2 noise_turn(real2 p) {
    precise real x = real(0.8) * p.x - real(0.6) * p.y;
    precise real y = real(0.6) * p.x + real(0.8) * p.y;
    return real2(x, y);
}
