// Nothing hit.
layout(location = 0) out vec2 hit_out;

void main() { hit_out = vec2(uintBitsToFloat(0x7f800000u), 0.0); }
