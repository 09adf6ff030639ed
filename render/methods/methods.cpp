#include <fmt/format.h>

#include "render/methods/method.h"
#include "sim/error.h"

namespace talus::render {

const std::vector<MethodEntry>& methods() {
    static const std::vector<MethodEntry> entries = {
        {"exact", "a ray per pixel through the pyramid onto the bilinear surface", make_exact, true, false},
        {"boxes", "the same walk onto a column for each patch (Dick et al. 2009)", make_boxes, true, false},
        {"mesh", "two triangles a patch at full resolution, culled by cells", make_mesh, false, false},
        {"hybrid", "the cheapest of mesh and rays, cell by cell", make_hybrid, true, true},
        {"relief", "evenly spaced samples along each ray, then halvings (Policarpo et al. 2005)", make_relief,
         false, false, relief_parameters()},
    };
    return entries;
}

const MethodEntry& method_named(const std::string& name, const std::string& option) {
    std::string names;
    for (const MethodEntry& entry : methods()) {
        if (entry.name == name) return entry;
        names += (names.empty() ? "" : ", ") + entry.name;
    }
    throw Error(fmt::format("{} '{}' is none, it must be one of: {}", option, name, names));
}

std::vector<std::string> detail_defines(Detail detail) {
    if (detail == Detail::steps) return {"COUNT_STEPS"};
    if (detail == Detail::kind) return {"TELL_KIND"};
    return {};
}

}  // namespace talus::render
