#include "sim/passes/map_settings.h"

namespace talus {

const std::vector<Parameter>& map_parameters() {
    static const std::vector<Parameter> table = {
        choice(
            "maps.count", "with erosion", {"with erosion", "always", "never"},
            "When flow, wear and deposition are counted in every sample: while erosion is on, always, or "
            "never. "
            "Otherwise they stay as they are. Counting makes a tick up to a fifth slower and takes up to 56 "
            "bytes a sample.")
            .labelled("Count maps")};
    return table;
}

bool counts_maps(const Parameters& parameters) {
    const std::string& when = parameters.choice("maps.count");
    return when == "always" || (when == "with erosion" && parameters.toggle("erosion.on"));
}

}  // namespace talus
