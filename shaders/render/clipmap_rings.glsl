// The rings of a geometry clipmap (Losasso & Hoppe 2004): each level a square of samples around the eye, twice as far apart as the
// finer level's. Their heights lie in one image, level below level, each wrapped around in both directions.

layout(std430) readonly buffer RingOrigins { ivec2 ring_origins[]; };  // first column and row, in the level's spacing; even

uniform int side;    // samples in a row and in a column of a level, n
uniform int levels;

int wrapped(int at) {
    int turns = at >= 0 ? at / side : -((side - 1 - at) / side);
    return at - turns * side;
}

// Of a sample of a level, by its column and row in the level's spacing.
int2 ring_texel(int2 at, int level) { return int2(wrapped(at.x), wrapped(at.y) + level * side); }
