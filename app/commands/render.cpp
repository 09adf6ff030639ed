#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <nlohmann/json.hpp>

#include "app/commands/commands.h"
#include "app/core/first_look.h"
#include "app/core/flight.h"
#include "app/core/outputs.h"
#include "app/core/report.h"
#include "app/core/sitter.h"
#include "sim/error.h"
#include "sim/io/atomic_file.h"
#include "sim/io/endings.h"
#include "sim/io/image_file.h"

namespace talus::app {
namespace {

// picture.png becomes picture-0007.png.
std::string numbered(const std::string& path, std::size_t number) {
    return fmt::format("{}-{:04}.png", path.substr(0, path.size() - 4), number);
}

bool is_film(const RenderOptions& options) {
    return !options.keys.empty() || options.turntable > 0;
}

// Where not all tiles fit that a picture asked for.
void say_tolerance(const Sitter& sitter) {
    if (sitter.photo_px && sitter.photo_px() > 1)
        say(fmt::format(
            "note: the photo's texels are up to {:.1f} pixels wide, finer ones would not fit into "
            "tiles.photo_mib",
            sitter.photo_px()));
    if (!sitter.tiles) return;
    const TiledFigures tiles = sitter.tiles();
    if (tiles.tolerance_px > tiles.asked_px)
        say(fmt::format(
            "note: tiles within {:.2f} pixels would not fit into tiles.gpu_mib, those that do are within "
            "{:.2f} pixels",
            tiles.asked_px, tiles.tolerance_px));
}

void check(const RenderOptions& options) {
    if (options.eye && options.target && *options.eye == *options.target)
        throw Error("--eye and --target are the same point, so there is no direction to look in");
    if (!options.camera.empty() && (options.eye || options.target || is_film(options)))
        throw Error(
            "--camera says where the camera stands: leave out --eye, --target, --keys and --turntable");
    for (const std::string& file : {options.image, options.depth, options.report})
        if (!file.empty()) check_folder(file);
    if (options.size.x < 1 || options.size.y < 1 || options.size.x > 32768 || options.size.y > 32768)
        throw Error(fmt::format("--size {}x{} cannot be drawn, each side must be 1 to 32768 pixels",
                                options.size.x, options.size.y));
    if (static_cast<std::int64_t>(options.size.x) * options.size.y > std::int64_t{1} << 28)
        throw Error(fmt::format("--size {}x{} cannot be drawn, a picture holds at most 268435456 pixels",
                                options.size.x, options.size.y));
    if (options.image.empty() && options.depth.empty() && options.report.empty() && !options.json)
        throw Error("render writes nothing: give --image, --depth or --report");
    if (is_film(options) &&
        (options.image.empty() || !options.depth.empty() || !options.report.empty() || options.json))
        throw Error(
            "--keys and --turntable write frames alone: give --image, and neither --depth nor a report");
    if (!options.image.empty() && io::ending_of(options.image) != ".png")
        throw Error(fmt::format("cannot write the picture '{}': its ending must be .png", options.image));
    if (!options.depth.empty() && io::ending_of(options.depth) != ".exr")
        throw Error(fmt::format("cannot write the depth '{}': its ending must be .exr", options.depth));
}

}  // namespace

void render(const RenderOptions& options) {
    check(options);
    const gpu::Context context(options.gpu);
    say(gpu::describe(context.device()));
    Sitter sitter = make_sitter(options.scene, context.device());
    for (const std::string& note : sitter.notes) say("note: " + note);
    const Grid& grid = sitter.grid;
    render::Camera camera =
        first_look(sitter.view, grid, {sitter.lowest_m, sitter.highest_m},
                   static_cast<double>(options.size.x) / options.size.y, options.turntable > 0);
    if (camera.is_parallel()) render::keep_over(camera, grid, sitter.highest_around_m);
    if (!options.camera.empty()) camera = camera_named(sitter.cameras, options.camera);
    if (camera.is_parallel() && (options.eye || options.target || options.turntable > 0))
        throw Error(
            "--eye, --target and --turntable are of a view through an eye, and this one is from the top: add "
            "--set camera.mode=orbit");
    if (options.eye) camera.eye = *options.eye;
    if (options.target) camera.target = *options.target;
    if (camera.eye == camera.target)
        throw Error("--eye and --target are the same point, so there is no direction to look in");
    if (is_film(options)) {
        const glm::dvec2 middle(grid.width_m() / 2, grid.height_m() / 2);
        const std::vector<render::Camera> way =
            options.keys.empty() ? turn_around(camera, middle, options.turntable)
                                 : fly_along(read_keys(options.keys, camera.fov_deg), options.frames);
        for (std::size_t i = 0; i < way.size(); ++i) {
            const Still still =
                draw_still(sitter.painter, way[i], sitter.legends, options.size, sitter.samples);
            io::write_rgb(numbered(options.image, i), options.size.x, options.size.y, still.rgb);
        }
        say_tolerance(sitter);
        return;
    }
    const double cpu_start = process_cpu_s();
    const int samples = options.image.empty() ? 1 : sitter.samples;
    const Still still = draw_still(sitter.painter, camera, sitter.legends, options.size, samples);
    const double cpu_s = process_cpu_s() - cpu_start;
    const std::vector<float>& depth = still.depth_m;
    if (!options.image.empty()) io::write_rgb(options.image, options.size.x, options.size.y, still.rgb);
    if (!options.depth.empty()) io::write_depth(options.depth, options.size.x, options.size.y, depth);
    nlohmann::ordered_json report;
    report["device"] = gpu::describe(context.device());
    report["method"] = sitter.method;
    report["width"] = options.size.x;
    report["height"] = options.size.y;
    report["eye"] = {camera.eye.x, camera.eye.y, camera.eye.z};
    report["target"] = {camera.target.x, camera.target.y, camera.target.z};
    if (camera.is_parallel())
        report["height_m"] = camera.parallel_m;
    else
        report["fov_deg"] = camera.fov_deg;
    report["pixels_hit"] =
        std::count_if(depth.begin(), depth.end(), [](float d) { return std::isfinite(d); });
    report["samples"] = samples;
    report["cpu_s"] = cpu_s;
    say_tolerance(sitter);
    if (sitter.tiles) {
        const TiledFigures tiles = sitter.tiles();
        report["tiles"] = {{"drawn", tiles.drawn},
                           {"tolerance_px", tiles.tolerance_px},
                           {"device_bytes", tiles.device_bytes}};
    }
    if (!options.report.empty()) io::write_atomically(options.report, report.dump(2) + "\n");
    if (options.json) fmt::print("{}\n", report.dump(2));
}

}  // namespace talus::app
