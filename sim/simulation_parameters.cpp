#include "sim/simulation_parameters.h"

#include "sim/terrain/generate.h"
#include "sim/terrain/grid.h"

namespace talus {

std::vector<Parameter> simulation_parameters() {
    return {
        choice("terrain.kind", "mountains", generator_kinds(),
               "Shape of the generated terrain, where no file is opened."),
        whole("terrain.nx", 513, min_samples, max_samples, "samples", "Columns of the generated terrain."),
        whole("terrain.ny", 513, min_samples, max_samples, "samples", "Rows of the generated terrain."),
        number("terrain.spacing_m", 20, 1e-3, 1e5, "m", "Distance between samples of the generated terrain."),
        number("terrain.relief_m", 1800, 0, 1e5, "m",
               "Height of the generated terrain from lowest to highest."),
        whole("terrain.seed", 1, 0, 1000000, "", "Another seed gives another generated terrain."),
        number("time.tick_s", 1.0 / 60, 1e-6, 1e9, "s", "Simulated time of one tick."),
        toggle("thermal.on", true, "Thermal erosion: what is steeper than its angle of repose slides."),
        number("thermal.repose_deg", 33, 1, 80, "°",
               "Angle of repose: the steepest slope at which loose ground rests."),
        number("thermal.rate_m2_per_s", 0, 0, 1e12, "m²/s",
               "How fast steep ground slides. Unless set, it follows the spacing: one sub-step a tick."),
    };
}

}  // namespace talus
