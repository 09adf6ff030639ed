#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "sim/io/export.h"

namespace talus::io {

/// Writes the maps of the settings, whose kind is maps, and one JSON with their names, units, files, and the
/// values of the smallest and largest integer. Tells of each what it holds. Throws talus::Error where the
/// settings cannot be, before anything is written, and where a file cannot be written; then those before it
/// are there, and no new JSON.
Exported export_maps(const TerrainState& state, const ExportSettings& settings);

/// A map's values as shares, 0 to 1, of what it can be: flow by its logarithm, over four powers of ten below
/// its largest; slope of 60 degrees; hardness and mask as they are; others of their range, the upper
/// two-hundredth of samples being 1.
std::vector<float> shares_of(const std::string& map, const std::vector<float>& values);

/// Shares (one plane for each map) as whole numbers that sum to `sum` at every sample, with a last plane for
/// the rest; where shares sum to more than 1 they are scaled down. Rounded by largest remainders, so that
/// none is farther than 1 from what it should be.
std::vector<std::vector<std::uint16_t>> weights_of(const std::vector<std::vector<float>>& shares, int sum);

}  // namespace talus::io
