#include "render/methods/method.h"

namespace talus::render {

const std::vector<MethodEntry>& methods() {
    static const std::vector<MethodEntry> entries = {
        {"exact", "a ray per pixel through the pyramid onto the bilinear surface", make_exact, true, false},
        {"boxes", "the same walk onto a column for each patch (Dick et al. 2009)", make_boxes, true, false},
        {"mesh", "two triangles a patch at full resolution, culled by cells", make_mesh, false, false},
        {"hybrid", "the cheapest of mesh and rays, cell by cell", make_hybrid, true, true},
    };
    return entries;
}

std::vector<std::string> detail_defines(Detail detail) {
    if (detail == Detail::steps) return {"COUNT_STEPS"};
    if (detail == Detail::kind) return {"TELL_KIND"};
    return {};
}

}  // namespace talus::render
