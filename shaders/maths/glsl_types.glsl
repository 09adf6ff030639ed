// The names that the per-sample maths is written in, as GLSL has them. shaders/maths/twin.h gives them to C++.
#define real float
#define real2 vec2
#define real3 vec3
#define real4 vec4
#define int2 ivec2
// A line of a uniform block, which C++ declares by the same line (sim/gpu/uniform_block.h).
#define NUMBER(type, name) type name;
