// Where a fragment lies in the picture, from its pixel centre: interpolated values would differ by driver.
#include "render/camera.glsl"

real2 picture_position() { return real2(2.0 * gl_FragCoord.x / picture_size.x - 1.0, 2.0 * gl_FragCoord.y / picture_size.y - 1.0); }
