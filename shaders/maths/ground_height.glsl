// Of a sample's solid, real4(bedrock high, bedrock low, regolith high, regolith low).

// Ground height, metres.
real ground_height(real4 solid) {
    precise real sum = (solid.x + solid.z) + (solid.y + solid.w);
    return sum;
}
