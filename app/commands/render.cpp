#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <nlohmann/json.hpp>

#include "app/commands/commands.h"
#include "app/core/calibration.h"
#include "app/core/flight.h"
#include "app/core/report.h"
#include "app/core/still.h"
#include "render/overview.h"
#include "sim/error.h"
#include "sim/io/atomic_file.h"
#include "sim/io/endings.h"
#include "sim/io/image_file.h"
#include "sim/terrain/terrain.h"

namespace talus::app {
namespace {

// picture.png becomes picture-0007.png.
std::string numbered(const std::string& path, std::size_t number) {
    return fmt::format("{}-{:04}.png", path.substr(0, path.size() - 4), number);
}

}  // namespace

void render(const RenderOptions& options) {
    if (options.size.x < 1 || options.size.y < 1 || options.size.x > 32768 || options.size.y > 32768)
        throw Error(fmt::format("--size {}x{} cannot be drawn, each side must be 1 to 32768 pixels",
                                options.size.x, options.size.y));
    if (static_cast<std::int64_t>(options.size.x) * options.size.y > std::int64_t{1} << 28)
        throw Error(fmt::format("--size {}x{} cannot be drawn, a picture holds at most 268435456 pixels",
                                options.size.x, options.size.y));
    if (options.image.empty() && options.depth.empty() && options.report.empty() && !options.json)
        throw Error("render writes nothing: give --image, --depth or --report");
    const bool film = !options.keys.empty() || options.turntable > 0;
    if (film && (options.image.empty() || !options.depth.empty() || !options.report.empty() || options.json))
        throw Error(
            "--keys and --turntable write frames alone: give --image, and neither --depth nor a report");
    if (!options.image.empty() && io::ending_of(options.image) != ".png")
        throw Error(fmt::format("cannot write the picture '{}': its ending must be .png", options.image));
    if (!options.depth.empty() && io::ending_of(options.depth) != ".exr")
        throw Error(fmt::format("cannot write the depth '{}': its ending must be .exr", options.depth));
    const gpu::Context context(options.gpu);
    say(gpu::describe(context.device()));
    const Scene scene = make_scene(options.scene);
    for (const std::string& note : scene.document.notes) say("note: " + note);
    const Grid& grid = scene.document.state.grid;
    const std::vector<float> ground = scene.document.state.ground();
    const auto [low, high] = std::minmax_element(ground.begin(), ground.end());
    render::Camera camera = render::overview(grid, *low, *high,
                                             {static_cast<double>(options.size.x) / options.size.y,
                                              scene.view.number("camera.fov_deg"), options.turntable > 0});
    if (options.eye) camera.eye = *options.eye;
    if (options.target) camera.target = *options.target;
    if (camera.eye == camera.target)
        throw Error("--eye and --target are the same point, so there is no direction to look in");
    const render::ViewSettings settings = render::view_settings(scene.view, scene.simulation);
    Terrain terrain(scene.document.state);
    render::Renderer renderer(terrain, patch_pixels(context.device()));
    drape(renderer, scene);
    const std::vector<render::Legend> legends = render::legend_of(settings, *low, *high);
    const int samples = scene.view.whole("render.samples");
    if (film) {
        const glm::dvec2 middle(grid.width_m() / 2, grid.height_m() / 2);
        const std::vector<render::Camera> way =
            options.keys.empty() ? turn_around(camera, middle, options.turntable)
                                 : fly_along(read_keys(options.keys, camera.fov_deg), options.frames);
        for (std::size_t i = 0; i < way.size(); ++i) {
            const Still still =
                draw_still(renderer, terrain, way[i], settings, legends, options.size, samples);
            io::write_rgb(numbered(options.image, i), options.size.x, options.size.y, still.rgb);
        }
        return;
    }
    const double cpu_start = process_cpu_s();
    const Still still = draw_still(renderer, terrain, camera, settings, legends, options.size,
                                   options.image.empty() ? 1 : samples);
    const double cpu_s = process_cpu_s() - cpu_start;
    const std::vector<float>& depth = still.depth_m;
    if (!options.image.empty()) io::write_rgb(options.image, options.size.x, options.size.y, still.rgb);
    if (!options.depth.empty()) io::write_depth(options.depth, options.size.x, options.size.y, depth);
    if (options.report.empty() && !options.json) return;
    nlohmann::ordered_json report;
    report["device"] = gpu::describe(context.device());
    report["method"] = settings.method;
    report["width"] = options.size.x;
    report["height"] = options.size.y;
    report["eye"] = {camera.eye.x, camera.eye.y, camera.eye.z};
    report["target"] = {camera.target.x, camera.target.y, camera.target.z};
    report["fov_deg"] = camera.fov_deg;
    report["pixels_hit"] =
        std::count_if(depth.begin(), depth.end(), [](float d) { return std::isfinite(d); });
    report["samples"] = options.image.empty() ? 1 : samples;
    report["cpu_s"] = cpu_s;
    if (!options.report.empty()) io::write_atomically(options.report, report.dump(2) + "\n");
    if (options.json) fmt::print("{}\n", report.dump(2));
}

}  // namespace talus::app
