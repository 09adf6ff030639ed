// Ground height of b above a, metres. Words are subtracted like from like, so a datum of thousands of metres
// costs nothing; rise(a, b) is -rise(b, a) to the bit.
real rise(real4 a, real4 b) {
    precise real high = (b.x - a.x) + (b.z - a.z);
    precise real low = (b.y - a.y) + (b.w - a.w);
    precise real sum = high + low;
    return sum;
}
