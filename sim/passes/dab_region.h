#pragma once
#include "sim/gpu/region.h"
#include "sim/passes/dab.h"
#include "sim/terrain/terrain.h"

namespace talus {

/// The samples that a dab can change; may reach beyond the terrain.
gpu::Region dab_region(const Grid& grid, const Dab& dab);

/// Whether the dab goes by the mask where none was painted: the mask is 0 there, so it changes nothing.
inline bool is_masked_out(const Terrain& terrain, const Dab& dab) {
    return dab.masked && !terrain.painted;
}

/// The samples that an erode dab works on, within the map: a square around it, wide enough for what it takes
/// to settle beside it. As large wherever the dab is.
gpu::Region erode_window(const Grid& grid, const Dab& dab);

}  // namespace talus
