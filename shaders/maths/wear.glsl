// Wear and deposition: how much ground was taken from a sample and laid on it, gross, m, each in two words.
// Needs maths/rise.glsl and maths/two_sum.glsl.

// real4(wear, its low word, deposition, its low word) after the sample's solid changed.
real4 wear_counted(real4 counted, real4 before, real4 after) {
    real change = rise(before, after);
    real2 wear = add_increment(real2(counted.x, counted.y), max(-change, real(0)));
    real2 deposition = add_increment(real2(counted.z, counted.w), max(change, real(0)));
    return real4(wear.x, wear.y, deposition.x, deposition.y);
}
