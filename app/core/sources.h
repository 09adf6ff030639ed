#pragma once
#include <glm/glm.hpp>
#include <string>

#include "sim/io/heightmap.h"
#include "sim/operation.h"

namespace talus::app {

/// An import of a file, with what it holds. Throws talus::Error when it cannot be read.
Import read_import(const std::string& path, const io::ImportSettings& import);
/// A file as the stamp.
ChooseStamp read_stamp(const std::string& path, const io::ImportSettings& import);

/// Reads what an operation of a journal needs from files, and checks that it is what it was. Throws
/// talus::Error when it is not.
void read_sources(Operation& operation);

/// Adapts an operation to a replay with `ratio` times as many samples along each axis: multiplies its numbers
/// of samples by `ratio`, and resamples an imported terrain.
void rescale(Operation& operation, glm::dvec2 ratio);

}  // namespace talus::app
