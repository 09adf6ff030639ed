// Water on the device: images with two ghost samples beyond every edge, so that no load asks where it is.
#include "maths/glsl_types.glsl"

#include "sim/water_layout.glsl"

layout(std140) uniform WaterNumbers {
#include "maths/water_numbers.glsl"
};

// What the step pass decides for the passes of a sub-step; time lives here (law 7).
layout(std430) buffer WaterClock {
#include "sim/water_clock.glsl"
};
