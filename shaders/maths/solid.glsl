// A sample's solid: real4(bedrock high, bedrock low, regolith high, regolith low), metres.
#include "maths/two_sum.glsl"

// Ground height of b above a, metres. Words are subtracted like from like, so a datum of thousands of metres
// costs nothing; rise(a, b) is -rise(b, a) to the bit.
real rise(real4 a, real4 b) {
    precise real high = (b.x - a.x) + (b.z - a.z);
    precise real low = (b.y - a.y) + (b.w - a.w);
    precise real sum = high + low;
    return sum;
}

// Ground height, metres.
real ground_height(real4 solid) {
    precise real sum = (solid.x + solid.z) + (solid.y + solid.w);
    return sum;
}

// The sample after `gain` metres arrived as regolith and `loss` metres left: regolith first, bedrock for the rest.
real4 exchange_solid(real4 solid, real gain, real loss) {
    real2 bedrock = real2(solid.x, solid.y);
    real2 regolith = real2(solid.z, solid.w);
    if (loss <= solid.z) {
        precise real net = gain - loss;
        regolith = add_increment(regolith, net);
    } else {
        precise real rest = (solid.z - loss) + solid.w;
        bedrock = add_increment(bedrock, rest);
        regolith = real2(gain, real(0));
    }
    return real4(bedrock.x, bedrock.y, regolith.x, regolith.y);
}
