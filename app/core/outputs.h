#pragma once
#include <optional>
#include <string>
#include <vector>

#include "app/core/report.h"
#include "app/core/scene.h"

namespace talus::app {

/// Files that a run leaves, and what goes into single-layer ones.
struct Outputs {
    std::vector<std::string> files;
    std::string layer;  ///< empty: ground; with a name, .exr holds that layer alone instead of the document
    std::string image;
    std::string report;
    std::string journal;
    bool json = false;  ///< the report on stdout
};

/// Throws talus::Error, before any work is done, when an output's ending cannot be written.
void check_outputs(const Outputs& outputs);

/// Throws talus::Error when there is no folder to write this file into.
void check_folder(const std::string& file);

/// Writes one terrain file: .exr as the document (or one layer), the others as a heightmap of the layer.
void write_terrain(const std::string& path, const io::Document& document, const std::string& layer,
                   std::optional<glm::dvec2> range_m);

/// The document holds what the simulation does now: its state and parameters. Waits for the device.
void bring_up(io::Document& document, const Simulation& simulation);

/// Writes the files, the picture (first look, with the view's legend), the journal and the report of a
/// finished run.
void write_outputs(const Outputs& outputs, Scene& scene, Simulation& simulation, const RunFigures& figures);

}  // namespace talus::app
