// A sample's solid: real4(bedrock high, bedrock low, regolith high, regolith low), metres.
#include "maths/ground_height.glsl"
#include "maths/rise.glsl"
#include "maths/two_sum.glsl"

// The sample after `gain` metres of solid arrived as regolith and `loss` metres left: regolith first, bedrock for the
// rest. `bulking`: metres of regolith that a metre of solid makes.
real4 exchange_solid(real4 solid, real gain, real loss, real bulking) {
    real2 bedrock = real2(solid.x, solid.y);
    real2 regolith = real2(solid.z, solid.w);
    precise real loss_loose = loss * bulking;
    precise real gain_loose = gain * bulking;
    if (loss_loose <= solid.z) {
        precise real net = (gain - loss) * bulking;
        regolith = add_increment(regolith, net);
    } else {
        precise real rest = (solid.z - loss_loose) + solid.w;
        precise real rest_solid = rest / bulking;
        bedrock = add_increment(bedrock, rest_solid);
        regolith = real2(gain_loose, real(0));
    }
    return real4(bedrock.x, bedrock.y, regolith.x, regolith.y);
}

// The sample after `change` metres of ground: what is added is bedrock or regolith, what is taken regolith first.
real4 change_ground(real4 solid, real change, bool adds_regolith) {
    if (change > real(0) && !adds_regolith) {
        real2 bedrock = add_increment(real2(solid.x, solid.y), change);
        return real4(bedrock.x, bedrock.y, solid.z, solid.w);
    }
    return exchange_solid(solid, max(change, real(0)), max(-change, real(0)), real(1));
}
