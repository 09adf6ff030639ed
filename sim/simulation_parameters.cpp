#include "sim/simulation_parameters.h"

#include "sim/passes/passes.h"
#include "sim/terrain/generate.h"
#include "sim/terrain/grid.h"

namespace talus {

std::vector<Parameter> simulation_parameters() {
    std::vector<Parameter> all = {
        choice("terrain.kind", "mountains", generator_kinds(),
               "Shape of the generated terrain, where no file is opened.")
            .labelled("Shape"),
        whole("terrain.nx", 513, min_samples, max_samples, "samples", "Columns of the generated terrain.")
            .labelled("Samples to the east"),
        whole("terrain.ny", 513, min_samples, max_samples, "samples", "Rows of the generated terrain.")
            .labelled("Samples to the north"),
        number("terrain.spacing_m", 20, 1e-3, 1e5, "m", "Distance between samples of the generated terrain.")
            .following_tables(Driven::never),
        number("terrain.relief_m", 1800, 0, 1e5, "m",
               "Height of the generated terrain from lowest to highest.")
            .following_tables(Driven::never),
        whole("terrain.seed", 1, 0, 1000000, "", "Another seed gives another generated terrain."),
        choice("terrain.water", "none", starting_waters(),
               "Water that the generated terrain starts with: none; dam, behind a dam a third of the way "
               "east that "
               "has just gone; bowl, Thacker's round wave; wave, a sea with a single wave on its way "
               "eastwards; cloudburst, a quarter of a metre everywhere.")
            .labelled("Water at the start"),
        number("time.tick_s", 1.0 / 60, 1e-6, 1e9, "s", "Simulated time of one tick.")
            .labelled("Tick")
            .following_tables(Driven::never)};
    for (const PassKind& kind : pass_kinds())
        all.insert(all.end(), kind.parameters.begin(), kind.parameters.end());
    return all;
}

}  // namespace talus
