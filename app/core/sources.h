#pragma once
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "sim/io/heightmap.h"
#include "sim/operation.h"
#include "sim/simulation.h"

namespace talus::app {

/// An import of a file, with what it holds. Throws talus::Error when it cannot be read.
Import read_import(const std::string& path, const io::ImportSettings& import);
/// A stamp of the shelf. Throws talus::Error where there is none of the name.
ChooseStamp shelf_stamp(const std::string& name);
/// A file as the stamp.
ChooseStamp read_stamp(const std::string& path, const io::ImportSettings& import);

/// A raster as a painted number of this terrain, and what is to be noted of it.
struct ReadRaster {
    TakeRaster take;
    std::vector<std::string> notes;
};
ReadRaster read_raster(const std::string& number, const std::string& path, const Grid& grid,
                       const std::optional<Georeference>& georeference);

/// Reads what an operation of a journal needs from files, for the terrain as it is now, and checks that it is
/// what it was, but for rasters over another number of samples than was recorded. Throws talus::Error when it
/// is not.
void read_sources(Operation& operation, const Simulation& simulation, bool as_recorded = true);

/// Adapts an operation to a replay with `ratio` times as many samples along each axis: multiplies its numbers
/// of samples by `ratio`, and resamples an imported terrain.
void rescale(Operation& operation, glm::dvec2 ratio);

}  // namespace talus::app
