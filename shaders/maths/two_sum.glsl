// Heights of two words: high + low, |low| <= half an ulp of high.

// The height after an increment, exact to the last bit of the low word (Knuth 1997, The Art of Computer
// Programming vol. 2, 4.2.2, theorem B). Increments below one ulp of the height add up in the low word.
real2 add_increment(real2 height, real increment) {
    precise real small = height.y + increment;
    precise real high = height.x + small;
    precise real part = high - height.x;
    precise real low = (height.x - (high - part)) + (small - part);
    return real2(high, low);
}
