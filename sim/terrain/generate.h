#pragma once
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include <glm/glm.hpp>

#include "sim/terrain/grid.h"

namespace talus {

/// How a generated terrain looks.
struct GeneratorSettings {
    std::string kind = "mountains";  ///< one of generator_kinds()
    std::uint32_t seed = 1;
    double relief_m = 1000;  ///< from the lowest to the highest sample
};

/// mountains (ridged noise, its detail damped on slopes, domain warped), hills (fBm), flat (all 0), coast (a
/// shelf in the west, a beach, hills in the east), island (on a shelf), valley (winding, falls eastwards),
/// bowl (a paraboloid), massif (a smooth upland that no water has cut), plateau (a table with a river's
/// course and an escarpment), delta (a flood plain, a gorge and a lake basin), spectrogram (parallel narrow
/// ridges), high_amplitude (horns).
const std::vector<std::string>& generator_kinds();

/// Whether another seed makes another terrain of this kind, and whether it has a relief. Throws talus::Error
/// where there is no such kind.
bool has_seed(const std::string& kind);
bool has_relief(const std::string& kind);

/// Heights in metres, row 0 north, lowest sample 0, highest relief_m. The same terrain at every grid of the
/// same extent, and the same bits on every machine: + - * / sqrt floor and whole numbers only. Throws
/// talus::Error where there is no such kind.
std::vector<float> generate_heights(const Grid& grid, const GeneratorSettings& settings);

/// The same kinds of terrain for grids of any size, a sample at a time, from any thread. Beyond 8192 samples
/// it has finer octaves, down to about two samples. Of 257 x 257 places all over it the lowest lies at 0 and
/// the highest at relief_m; what lies between may go a little beyond. Throws talus::Error where there is no
/// such kind.
std::function<float(int column, int row)> generate_sample_by_sample(const Grid& grid,
                                                                    const GeneratorSettings& settings);

/// What water a generated terrain can start with: none; dam, to a level of 0.6 of the relief in the western
/// third; bowl, Thacker's round wave (1981) in a bowl a quarter of the width wide, at its lowest spread;
/// wave, a sea on which a single wave is on its way eastwards, its crest a sixth of the way; cloudburst, a
/// quarter of a metre everywhere.
const std::vector<std::string>& starting_waters();

/// How that water stands.
struct StartingWater {
    std::string kind = "none";
    double relief_m = 1000;  ///< of the terrain
    double sea_level_m = 0;  ///< wave
    double wave_height_m = 1;
    double gravity_m_per_s2 = 9.81;
};

/// Depth (m, two words) and discharge (m²/s) over the heights; empty for none.
std::vector<glm::vec4> generate_water(const Grid& grid, const std::vector<float>& heights_m,
                                      const StartingWater& water);

}  // namespace talus
