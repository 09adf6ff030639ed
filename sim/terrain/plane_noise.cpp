#include "sim/terrain/plane_noise.h"

#include "shaders/maths/twin.h"

namespace talus::maths {

template <typename Real>
struct NoiseTwin {
    TALUS_TWIN_NAMES(Real)
#include "maths/noise.glsl"
};

}  // namespace talus::maths

namespace talus {

double plane_noise(glm::dvec2 p, std::uint32_t seed) {
    return maths::NoiseTwin<double>().gradient_noise(p, seed);
}

glm::dvec2 turned_lattice(glm::dvec2 p) {
    return maths::NoiseTwin<double>().noise_turn(p);
}

double fbm(glm::dvec2 p, std::uint32_t seed, int octaves, double gain) {
    double sum = 0;
    double weight = 1;
    for (int octave = 0; octave < octaves; ++octave) {
        sum += weight * plane_noise(p, seed + static_cast<std::uint32_t>(octave));
        weight *= gain;
        p = 2.03 * turned_lattice(p) + glm::dvec2(17.1, 9.7);
    }
    return sum;
}

}  // namespace talus
