#include <fmt/format.h>

#include <cmath>

#include "render/methods/method.h"
#include "sim/error.h"

namespace talus::render {

const std::vector<MethodEntry>& methods() {
    static const std::vector<MethodEntry> entries = {
        {.name = "exact",
         .help = "a ray per pixel through the pyramid onto the bilinear surface",
         .make = make_exact,
         .redraws_blocks = true},
        {.name = "boxes",
         .help = "the same walk onto a column for each patch (Dick et al. 2009)",
         .make = make_boxes,
         .redraws_blocks = true},
        {.name = "mesh",
         .help = "two triangles a patch at full resolution, culled by cells",
         .make = make_mesh,
         .kinds = mesh_kinds},
        {.name = "hybrid",
         .help = "the cheapest of mesh and rays, cell by cell",
         .make = make_hybrid,
         .redraws_blocks = true,
         .heeds_tolerance = true},
        {.name = "uniform",
         .help = "samples of 8 x 8 patches along each ray, from an envelope on (Jeong & Han 2006)",
         .make = make_uniform,
         .kinds = uniform_kinds},
        {.name = "relief",
         .help = "evenly spaced samples along each ray, then halvings (Policarpo et al. 2005)",
         .make = make_relief,
         .parameters = relief_parameters(),
         .kinds = relief_kinds},
        {.name = "ammann",
         .help = "cells of mesh near by, of sampled rays farther off (Ammann et al. 2010)",
         .make = make_ammann,
         .parameters = ammann_parameters(),
         .kinds = ammann_kinds},
        {.name = "clipmap",
         .help = "rings of mesh around the eye, each twice as coarse as the inner one (Losasso & Hoppe 2004)",
         .make = make_clipmap,
         .parameters = clipmap_parameters(),
         .kinds = clipmap_kinds},
    };
    return entries;
}

std::vector<PixelKind> ray_kinds(const OwnNumbers&) {
    return {
        {1, "mesh"}, {2, "rays to the patch"}, {4, "rays ended at level 2"}, {8, "rays ended at level 6"}};
}

const MethodEntry& method_named(const std::string& name, const std::string& option) {
    std::string names;
    for (const MethodEntry& entry : methods()) {
        if (entry.name == name) return entry;
        names += (names.empty() ? "" : ", ") + entry.name;
    }
    throw Error(fmt::format("{} '{}' is none, it must be one of: {}", option, name, names));
}

void begin_nearest(const Frame& frame) {
    frame.hits.clear(0, {HUGE_VALF, 0, 0, 0});
    frame.hits.clear_depth();
    frame.hits.bind({0, 0, frame.width, frame.height});
}

std::vector<std::string> detail_defines(Detail detail) {
    if (detail == Detail::steps) return {"COUNT_STEPS"};
    if (detail == Detail::kind) return {"TELL_KIND"};
    return {};
}

}  // namespace talus::render
