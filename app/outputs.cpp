#include "app/outputs.h"

#include <fmt/format.h>

#include "app/panels/legend.h"
#include "render/renderer.h"
#include "sim/gpu/error.h"
#include "sim/io/atomic_file.h"
#include "sim/io/image_file.h"
#include "sim/preset.h"

namespace talus {

void check_outputs(const Outputs& outputs) {
    for (const std::string& file : outputs.files)
        if (!can_write_heightmap(file))
            throw Error(
                fmt::format("cannot write '{}': its ending must be one of {}", file, heightmap_endings));
    if (!outputs.image.empty() && ending_of(outputs.image) != ".png")
        throw Error(fmt::format("cannot write the picture '{}': its ending must be .png", outputs.image));
    if (!outputs.layer.empty()) layer_of({}, outputs.layer);
}

void write_terrain(const std::string& path, const Document& document, const std::string& layer,
                   std::optional<glm::dvec2> range_m) {
    if (ending_of(path) == ".exr" && layer.empty()) return save_document(path, document);
    Heightmap heightmap;
    heightmap.grid = document.state.grid;
    heightmap.heights = layer_of(document.state, layer.empty() ? "ground" : layer);
    heightmap.georeference = document.georeference;
    write_heightmap(path, heightmap, range_m);
}

void write_outputs(const Outputs& outputs, Scene& scene, Simulation& simulation, const RunFigures& figures) {
    scene.document.state = simulation.read();
    scene.document.parameters = to_toml(simulation.parameters());
    for (const std::string& file : outputs.files)
        write_terrain(file, scene.document, outputs.layer, outputs.range_m);
    if (!outputs.image.empty()) {
        constexpr int width = 1280;
        constexpr int height = 720;
        Renderer renderer(simulation.terrain());
        const std::vector<float> ground = scene.document.state.ground();
        const auto [low, high] = std::minmax_element(ground.begin(), ground.end());
        const ViewSettings settings = view_settings(scene.view);
        Camera camera = overview(scene.document.state.grid, *low, *high);
        camera.fov_deg = scene.view.number("camera.fov_deg");
        renderer.draw(simulation.terrain(), camera, settings, width, height);
        draw_legend_into(renderer.framebuffer(), width, height, legend_of(settings, *low, *high));
        write_rgb(outputs.image, width, height, renderer.read_rgb(width, height));
    }
    if (!outputs.journal.empty())
        write_atomically(outputs.journal, write_journal(scene.start, simulation.journal()));
    if (outputs.report.empty() && !outputs.json) return;
    const std::string report = run_report(figures, scene.document.state, simulation.ledger());
    if (!outputs.report.empty()) write_atomically(outputs.report, report);
    if (outputs.json) fmt::print("{}", report);
}

}  // namespace talus
