#include "sim/passes/passes.h"

namespace talus {

const std::vector<PassKind>& pass_kinds() {
    static const std::vector<PassKind> kinds = {
        ground_brush_pass(),  // by dabs alone
        paint_pass(),         // by dabs and masks alone
        thermal_pass(),       // slides
        water_pass(),         // finds the ground as the tick's slides left it
    };
    return kinds;
}

std::vector<std::unique_ptr<Pass>> passes_for(const Terrain& terrain) {
    std::vector<std::unique_ptr<Pass>> passes;
    passes.reserve(pass_kinds().size());
    for (const PassKind& kind : pass_kinds()) passes.push_back(kind.make(terrain));
    return passes;
}

}  // namespace talus
