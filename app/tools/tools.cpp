#include "app/tools/tools.h"

#include <algorithm>

namespace talus::app {

const std::vector<Tool>& tools() {
    static const std::vector<Tool> all = {
        raise_tool(),    lower_tool(),   smooth_tool(),    flatten_tool(),      height_tool(), ramp_tool(),
        noise_tool(),    terrace_tool(), stamp_tool(),     erode_tool(),        water_tool(),  rain_tool(),
        hardness_tool(), mask_tool(),    roughness_tool(), infiltration_tool(),
    };
    return all;
}

const Tool& tool_named(const std::string& name) {
    return *std::find_if(tools().begin(), tools().end(), [&](const Tool& tool) { return tool.name == name; });
}

std::vector<std::string> tool_names() {
    std::vector<std::string> names;
    for (const Tool& tool : tools()) names.push_back(tool.name);
    return names;
}

}  // namespace talus::app
