#pragma once
#include <cstdint>
#include <glm/glm.hpp>

namespace talus {

/// Gradient noise on the plane, about -0.7 to 0.7, as brushes have it on the device
/// (shaders/maths/noise.glsl): the same bits on every machine.
double plane_noise(glm::dvec2 p, std::uint32_t seed);
/// Octaves of it (fBm), each about twice as fine and `gain` times as high as the one before.
double fbm(glm::dvec2 p, std::uint32_t seed, int octaves, double gain);
/// A place in the lattice of the next octave, which is turned against this one.
glm::dvec2 turned_lattice(glm::dvec2 p);

}  // namespace talus
