#pragma once
#include <functional>
#include <glm/glm.hpp>
#include <vector>

#include "sim/tiled/tile_bounds.h"

namespace talus {

/// Heights of a large terrain from few of its samples: a rectangle of `size` heights over it, row by row,
/// each for as large a part of it. Where there is no time to read a sample for each, fewer are read, evenly
/// spread, and what lies between them is interpolated; so nothing is known of how far off they are. Samples
/// that are not known (NaN) become means of the known ones.
/// make_reader: of the terrain's finest level, which has `samples`; called once for each thread. budget_s: so
/// much time reading is to take; the first 16 samples may take six times as long. Empty where none
/// of what was read in time is known. Throws what the readers throw.
std::vector<float> sample_sparsely(glm::ivec2 samples, glm::ivec2 size,
                                   const std::function<ReadSamples()>& make_reader, double budget_s);

}  // namespace talus
