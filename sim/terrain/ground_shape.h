#pragma once
#include <vector>

#include "sim/terrain/grid.h"

namespace talus {

/// Of a ground (m, rows of samples, row 0 north) at each sample, by central differences that repeat the edge,
/// as masks are made of them (shaders/maths/mask.glsl): its slope, degrees, and its curvature, 1/km, crests
/// positive.
std::vector<float> slopes_deg(const Grid& grid, const std::vector<float>& ground_m);
std::vector<float> curvatures_per_km(const Grid& grid, const std::vector<float>& ground_m);

}  // namespace talus
