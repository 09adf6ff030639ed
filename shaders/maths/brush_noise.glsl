// The relief that a noise brush raises, about -1 to 1. Needs the numbers of maths/dab_numbers.glsl.
#include "maths/noise.glsl"

// Fractional Brownian motion; ridged: crests where noise crosses zero; billow: hollows there (Ebert et al. 2003,
// "Texturing and Modeling", chapter 16). Scaled by the sum of the weights, so that octaves add detail and no height.
real brush_noise_sum(real2 from, uint seed, int kind) {
    real2 p = from;
    precise real sum = real(0);
    precise real weight = real(1);
    precise real weights = real(0);
    for (int octave = 0; octave < noise_octaves; ++octave) {
        precise real n = real(1.45) * gradient_noise(p, seed + uint(octave));
        precise real shape = n;
        if (kind == noise_ridged) shape = real(1) - real(2) * abs(n);
        if (kind == noise_billow) shape = real(2) * abs(n) - real(1);
        sum = sum + weight * shape;
        weights = weights + weight;
        weight = weight * noise_gain;
        real2 turned = noise_turn(p);
        precise real x = real(2.03) * turned.x + real(17.1);
        precise real y = real(2.03) * turned.y + real(9.7);
        p = real2(x, y);
    }
    precise real value = sum / max(weights, real(1e-6));
    return value;
}

// At a place in wavelengths.
real brush_noise(real2 p) {
    if (noise_warp == real(0)) return brush_noise_sum(p, noise_seed, noise_kind);
    precise real x = p.x + noise_warp * brush_noise_sum(p, noise_seed + 101u, noise_fbm);
    precise real y = p.y + noise_warp * brush_noise_sum(p, noise_seed + 131u, noise_fbm);
    return brush_noise_sum(real2(x, y), noise_seed, noise_kind);
}
