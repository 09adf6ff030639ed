#pragma once
#include <memory>
#include <vector>

#include "sim/parameters.h"
#include "sim/passes/pass.h"

namespace talus {

/// A kind of pass: a line of the table.
struct PassKind {
    std::unique_ptr<Pass> (*make)(const Terrain& terrain);
    std::vector<Parameter> parameters = {};  ///< those that it declares
};

/// All kinds of passes, in the order of a tick.
const std::vector<PassKind>& pass_kinds();

/// One of each, made for this terrain.
std::vector<std::unique_ptr<Pass>> passes_for(const Terrain& terrain);

PassKind ground_brush_pass();
PassKind paint_pass();
PassKind thermal_pass();
PassKind water_pass();

}  // namespace talus
