// For maths/cube_root.glsl: minus a third of the exponent, by the bits of the number.
real inverse_cube_root_seed(real x) {
    precise real seed = float(floatBitsToInt(x)) * real(-0.33333333333333333) + real(1419967116.0);
    return intBitsToFloat(int(seed));
}
