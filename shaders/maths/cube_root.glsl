// Cube roots to the same bits on every device: a seed from the number's bits, then Newton without a division. The
// including side gives real inverse_cube_root_seed(real), within 4 % for any positive normal number.

// x to the power -1/3. Each step doubles the digits (e -> 2 e²): 4 %, 3e-3, 2e-5, 1e-9.
real inverse_cube_root(real x) {
    precise real third = x * real(0.33333333333333333);
    precise real y = inverse_cube_root_seed(x);
    y = y * (real(1.3333333333333333) - third * ((y * y) * y));
    y = y * (real(1.3333333333333333) - third * ((y * y) * y));
    y = y * (real(1.3333333333333333) - third * ((y * y) * y));
    return y;
}
