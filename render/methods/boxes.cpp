#include "render/methods/ray_casting.h"

namespace talus::render {

// Dick, Krueger & Westermann 2009, sections 3.1 and 3.2: the same walk, but a patch is a column as high as
// its middle.
Method make_boxes(Detail detail) {
    std::vector<std::string> defines = detail_defines(detail);
    defines.emplace_back("COLUMNS");
    return cast_rays(defines);
}

}  // namespace talus::render
