#include "sim/passes/map_settings.h"

namespace talus {

const std::vector<Parameter>& map_parameters() {
    static const std::vector<Parameter> table = {
        toggle("maps.on", true,
               "Flow, wear and deposition are counted in every sample. Off: they stay as they are.")};
    return table;
}

bool counts_maps(const Parameters& parameters) {
    return parameters.toggle("maps.on");
}

}  // namespace talus
