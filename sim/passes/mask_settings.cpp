#include "sim/passes/mask_settings.h"

#include <fmt/format.h>

#include "sim/error.h"

namespace talus {

const std::vector<std::string>& mask_source_names() {
    static const std::vector<std::string> names = {
        "height", "slope",      "curvature", "depth",      "largest_depth", "arrival",    "flow",
        "wear",   "deposition", "regolith",  "difference", "itself",        "everything", "rectangle"};
    return names;
}

const std::vector<std::string>& mask_join_names() {
    static const std::vector<std::string> names = {"replace", "add", "intersect", "subtract"};
    return names;
}

void check_mask(const MaskSettings& settings) {
    const std::string& name = mask_source_names()[static_cast<std::size_t>(settings.source)];
    constexpr double most = 1e12;
    const bool slope = settings.source == MaskSource::slope;
    if (slope && !(settings.low >= 0 && settings.high <= 90))
        throw Error(fmt::format("a mask by slope cannot go from {} to {} degrees, it must lie within 0 to 90",
                                settings.low, settings.high));
    if (!(settings.low >= -most && settings.high <= most && settings.low <= settings.high))
        throw Error(fmt::format("a mask by {} cannot go from {} to {}, the first must be the lower one", name,
                                settings.low, settings.high));
    const Rectangle& r = settings.rectangle;
    if (settings.source == MaskSource::rectangle && !(r.west_m < r.east_m && r.south_m < r.north_m))
        throw Error(
            fmt::format("a mask by rectangle cannot be {} to {} m wide and {} to {} m high, it must be "
                        "wider than nothing",
                        r.west_m, r.east_m, r.south_m, r.north_m));
    if (!(settings.fade >= 0 && settings.fade <= most))
        throw Error(
            fmt::format("a mask by {} cannot fade over {}, it must be 0 to {}", name, settings.fade, most));
}

}  // namespace talus
