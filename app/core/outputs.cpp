#include "app/core/outputs.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <functional>

#include "app/core/run_pictures.h"
#include "app/core/workspace.h"
#include "sim/error.h"
#include "sim/io/atomic_file.h"
#include "sim/io/endings.h"
#include "sim/io/heightmap_formats.h"
#include "sim/io/image_file.h"
#include "sim/preset.h"
#include "sim/terrain/layers.h"

namespace talus::app {

namespace {

// The first look at the terrain, with the view's legend.
void write_overview(const std::string& path, const Scene& scene, Simulation& simulation,
                    const gpu::Device& device) {
    RunPictures pictures(scene, simulation, device, {1280, 720});
    io::write_rgb(path, pictures.size().x, pictures.size().y, pictures.take(pictures.first_look()));
}

}  // namespace

void check_outputs(const Outputs& outputs) {
    for (const std::string& file : outputs.files)
        if (!io::can_write_heightmap(file))
            throw Error(fmt::format("cannot write '{}': its ending must be one of {}", file,
                                    fmt::join(io::writable_endings(), ", ")));
    if (!outputs.image.empty() && io::ending_of(outputs.image) != ".png")
        throw Error(fmt::format("cannot write the picture '{}': its ending must be .png", outputs.image));
    if (!outputs.layer.empty()) output_of({}, outputs.layer);
    std::vector<std::string> all = outputs.files;
    for (const std::string& file : {outputs.image, outputs.report, outputs.journal})
        if (!file.empty()) all.push_back(file);
    for (const std::string& file : all) check_folder(file);
}

void check_folder(const std::string& file) {
    const std::filesystem::path folder = std::filesystem::absolute(file).parent_path();
    if (!std::filesystem::is_directory(folder))
        throw Error(fmt::format("cannot write '{}': there is no folder '{}'", file, folder.string()));
}

void write_terrain(const std::string& path, const io::Document& document, const std::string& layer,
                   std::optional<glm::dvec2> range_m) {
    if (io::ending_of(path) == ".exr" && layer.empty()) return io::save_document(path, document);
    io::Heightmap heightmap;
    heightmap.grid = document.state.grid;
    heightmap.heights = output_of(document.state, layer.empty() ? "ground" : layer);
    heightmap.georeference = document.state.georeference;
    io::write_heightmap(path, heightmap, range_m);
}

namespace {

// What was placed on the map stays where that is the same one; its rows end where the run began.
std::string workspace_after(const std::string& text, bool same_map) {
    try {
        Workspace kept = without_rows(workspace_from(text));
        if (!same_map) {
            kept.camera.reset();
            kept.cameras.clear();
            kept.gauges.clear();
            kept.sections.clear();
            kept.path_m.clear();
        }
        return workspace_text(kept);
    } catch (const Error&) {
        // What cannot be read goes on as it is.
        return text;
    }
}

}  // namespace

void bring_up(io::Document& document, const Simulation& simulation) {
    const bool same_map = simulation.stands_on_its_first_terrain();
    const bool same_time = document.state.clock == simulation.clock();
    if (!document.workspace.empty() && !(same_map && same_time))
        document.workspace = workspace_after(document.workspace, same_map);
    document.state = simulation.read();
    document.parameters = to_toml(simulation.parameters());
}

void write_outputs(const Outputs& outputs, Scene& scene, Simulation& simulation, const RunFigures& figures) {
    bring_up(scene.document, simulation);
    // One output that fails takes none of the others with it.
    std::string failures;
    const auto attempt = [&](const std::function<void()>& write) {
        try {
            write();
        } catch (const Error& error) {
            failures += (failures.empty() ? "" : "; ") + std::string(error.what());
        }
    };
    for (const std::string& file : outputs.files)
        attempt([&] { write_terrain(file, scene.document, outputs.layer, std::nullopt); });
    if (!outputs.image.empty())
        attempt([&] { write_overview(outputs.image, scene, simulation, figures.device); });
    if (!outputs.journal.empty())
        attempt(
            [&] { io::write_atomically(outputs.journal, write_journal(scene.start, simulation.journal())); });
    if (!outputs.report.empty() || outputs.json) {
        const std::string report = run_report(figures, scene.document.state, simulation);
        if (!outputs.report.empty()) attempt([&] { io::write_atomically(outputs.report, report); });
        if (outputs.json) fmt::print("{}", report);
    }
    if (!failures.empty()) throw Error(failures);
}

}  // namespace talus::app
