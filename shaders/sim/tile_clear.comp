// Clears a flag bit in all tiles, once their list is made.
layout(local_size_x = 64) in;
layout(binding = 0, std430) buffer TileFlags { uint tile_flags[]; };
uniform uint flag_bit;
uniform int tile_count;

void main() {
    int index = int(gl_GlobalInvocationID.x);
    if (index < tile_count) tile_flags[index] &= ~flag_bit;
}
