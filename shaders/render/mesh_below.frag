// From below the ground everything is ground, at once.
layout(location = 0) out vec2 hit_out;

void main() { hit_out = vec2(0.0, 1.0); }
