#include "app/command_line.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <memory>

#include "app/command_options.h"
#include "app/commands/commands.h"
#include "app/core/opening.h"
#include "app/core/report.h"
#include "app/panels/style.h"
#include "app/window/glfw.h"
#include "app/window/window.h"
#include "sim/error.h"
#include "sim/gpu/shader_text.h"
#include "sim/io/time_series_file.h"

namespace talus::app {
namespace {

constexpr std::int64_t max_ticks = 1000000000;

// What the command line can ask for: a command with its options, and what it does once they are parsed.
struct Command {
    CLI::App* parsed;
    std::function<void()> act;
};

Command run_command(CLI::App& app, Texts& t) {
    auto options = std::make_shared<RunOptions>();
    CLI::App* command = app.add_subcommand("run", "run a scene without a window");
    command->add_option("--preset", t.preset, "a name ('talus presets' lists them) or a .toml file");
    command->add_option("--in", t.input, "start from this heightmap or document");
    command->add_option("--size", t.size, "NXxNY samples of generated terrain");
    auto* ticks = command->add_option("--ticks", options->ticks, "how many ticks to run");
    command->add_option("--time", options->time_s, "how many seconds to simulate")->excludes(ticks);
    command->add_option("--set", t.assignments, "section.name=value, may be repeated");
    command
        ->add_option("--gauge", t.gauges, "X,Y in metres: write the water there every tick; may be repeated")
        ->allow_extra_args(false);
    command->add_option("--gauges", options->gauge_table, "the table for them, gauges.csv unless given")
        ->type_name("FILE.csv");
    command
        ->add_option(
            "--section", t.sections,
            "X1,Y1,X2,Y2 in metres: write every tick what water passes this line, to the right of one who "
            "looks from 1 to 2; may be repeated")
        ->allow_extra_args(false);
    command->add_option("--sections", options->section_table, "the table for them, sections.csv unless given")
        ->type_name("FILE.csv");
    command->add_option("--spring", t.springs, "X,Y,RATE: a spring, metres and m³/s; may be repeated")
        ->allow_extra_args(false);
    command
        ->add_option(
            "--drive", t.drives,
            "section.name=FILE.csv: the number follows the table, rows of time_s,value; may be repeated")
        ->allow_extra_args(false);
    std::vector<std::string> painted;
    for (const PaintedNumberDescription& number : painted_numbers()) painted.push_back(number.name);
    command
        ->add_option(
            "--raster", t.rasters,
            fmt::format(
                "NUMBER=FILE: it is as a raster says, where that says anything; NUMBER is one of {}; may "
                "be repeated",
                fmt::join(painted, ", ")))
        ->allow_extra_args(false);
    add_texture(*command, t);
    command
        ->add_option("--every", options->recording.every_s,
                     "simulated seconds from one to the next of the files of --out and --image whose names "
                     "number them, "
                     "as in depth_%05d.tif, and of a film's pictures")
        ->type_name("SECONDS");
    command
        ->add_option(
            "--film", options->recording.film,
            "a film of the run, 25 pictures a second, by the program ffmpeg; a picture each tick unless "
            "--every says otherwise")
        ->type_name("OUT.mp4");
    command
        ->add_option(
            "--keys", options->recording.keys,
            "the camera of the film and of numbered pictures flies along the key cameras of this file")
        ->type_name("FILE.toml");
    command->add_option("--film-size", t.film_size, "WxH pixels of both, 1280x720 unless given");
    add_import(*command, t);
    add_outputs(*command, t, options->outputs);
    add_gpu(*command, t);
    return {command, [&t, options] {
                options->gpu = t.context();
                options->scene = t.scene(t.input);
                if (!t.size.empty()) options->scene.size = size_from(t.size);
                if (!t.film_size.empty()) options->recording.size = size_from(t.film_size, "--film-size");
                if (options->ticks && (*options->ticks < 0 || *options->ticks > max_ticks))
                    throw Error(fmt::format("--ticks {} cannot be run, it must be 0 to {}", *options->ticks,
                                            max_ticks));
                if (options->time_s && !(*options->time_s >= 0 && *options->time_s < 1e15))
                    throw Error(fmt::format("--time {} cannot be run, it must be 0 or more seconds",
                                            *options->time_s));
                for (const std::string& text : t.gauges) {
                    const std::vector<double> v = numbers("--gauge", text, ',', 2);
                    options->gauges.emplace_back(v[0], v[1]);
                }
                for (const std::string& text : t.sections) {
                    const std::vector<double> v = numbers("--section", text, ',', 4);
                    options->sections.push_back({{v[0], v[1]}, {v[2], v[3]}});
                }
                for (const std::string& text : t.springs) {
                    const std::vector<double> v = numbers("--spring", text, ',', 3);
                    options->springs.push_back({v[0], v[1], v[2]});
                }
                for (const std::string& text : t.drives) {
                    const auto [name, file] = named_file(
                        "--drive", text, "section.name=FILE.csv, e.g. water.rain_mm_per_h=rain.csv");
                    options->tables.push_back({file, {name, io::read_time_series(file)}});
                }
                for (const std::string& text : t.rasters) {
                    const auto [name, file] =
                        named_file("--raster", text, "NUMBER=FILE, e.g. manning=roughness.tif");
                    options->rasters.push_back({painted_number_named(name).name, file});
                }
                options->outputs.json = t.json;
                run(*options);
            }};
}

Command render_command(CLI::App& app, Texts& t) {
    auto options = std::make_shared<RenderOptions>();
    CLI::App* command = app.add_subcommand("render", "draw a terrain without a window");
    command->add_option("FILE", t.file, "heightmap or document")->required();
    add_tiled(*command, t);
    command->add_option("--image", options->image, "the picture")->type_name("OUT.png");
    command->add_option("--keys", options->keys, "fly along the key cameras of this file")
        ->type_name("FILE.toml");
    command->add_option("--frames", options->frames, "how many frames along the keys, 120 unless given");
    command->add_option("--turntable", options->turntable, "so many frames once around the terrain");
    command->add_option("--size", t.size, "WxH pixels, 1280x720 unless given; to 32768 a side");
    command->add_option("--eye", t.eye, "x,y,z in metres: east, north, up from the south-west sample");
    command->add_option("--target", t.target, "x,y,z in metres");
    command->add_option("--camera", options->camera, "a camera that the document keeps, by its name");
    command->add_option("--fov", t.fov, "vertical field of view in degrees");
    command->add_option("--method", t.method, "how the surface is drawn");
    command->add_option("--view", t.view, "what the colours show; 'talus parameters' lists the views");
    command->add_option("--set", t.assignments, "section.name=value, may be repeated");
    add_texture(*command, t);
    command->add_option("--depth", options->depth, "metres along each pixel's ray")->type_name("OUT.exr");
    command->add_option("--report", options->report, "write the report")->type_name("FILE.json");
    command->add_flag("--json", t.json, "print the report");
    add_import(*command, t);
    add_gpu(*command, t);
    return {command, [&t, options] {
                options->gpu = t.context();
                options->scene = t.scene(t.file);
                if (!t.size.empty()) options->size = size_from(t.size);
                if (!options->camera.empty() && !t.fov.empty())
                    throw Error("--camera brings its field of view: leave out --fov");
                options->eye = point_from("--eye", t.eye);
                options->target = point_from("--target", t.target);
                options->json = t.json;
                if (options->frames < 2 || options->frames > 100000 || options->turntable < 0 ||
                    options->turntable > 100000)
                    throw Error("--frames and --turntable cannot be drawn, they must be 2 to 100000");
                render(*options);
            }};
}

Command compare_command(CLI::App& app, Texts& t) {
    auto options = std::make_shared<CompareOptions>();
    CLI::App* command =
        app.add_subcommand("compare", "measure methods of drawing against the double-precision reference");
    command->add_option("FILE", t.file, "heightmap or document");
    command->add_option("--preset", t.preset, "generate the terrain of this preset instead");
    command->add_option("--samples", t.samples, "NXxNY samples of generated terrain");
    command->add_option("--method", options->methods, "a method, may be repeated; all unless given");
    command->add_option("--tolerance", t.tolerances,
                        "a,b,c: pixels that hybrid may err, 0,0.5,2 unless given");
    command->add_option("--size", t.size, "WxH pixels, 480x270 unless given");
    command->add_option("--set", t.assignments, "section.name=value of a method, may be repeated");
    command->add_option("--keys", options->keys, "fly along the key cameras of this file")
        ->type_name("FILE.toml");
    command->add_option("--frames", options->frames, "how many frames along the keys");
    command->add_option("--limit", options->limit_px, "pixels to look for a ray that agrees");
    command->add_option("--report", options->report, "write the report")->type_name("FILE.json");
    command->add_flag("--json", t.json, "print the report");
    add_import(*command, t);
    add_gpu(*command, t);
    return {
        command, [&t, options] {
            options->gpu = t.context();
            options->scene = t.scene(t.file);
            if (!t.samples.empty()) options->scene.size = size_from(t.samples, "--samples");
            if (!t.size.empty()) options->size = size_from(t.size);
            if (!t.tolerances.empty()) {
                const auto count = 1 + std::count(t.tolerances.begin(), t.tolerances.end(), ',');
                options->tolerances_px =
                    numbers("--tolerance", t.tolerances, ',', static_cast<std::size_t>(count));
            }
            for (const double tolerance : options->tolerances_px)
                if (!(tolerance >= 0 && tolerance <= 16))
                    throw Error(fmt::format("--tolerance {} cannot be compared, it must be 0 to 16 pixels",
                                            tolerance));
            if (!(options->limit_px > 0 && options->limit_px <= 64))
                throw Error(fmt::format("--limit {} cannot be used, it must be above 0 and at most 64 pixels",
                                        options->limit_px));
            if (options->frames < 2 || options->frames > 100000)
                throw Error(
                    fmt::format("--frames {} cannot be flown, it must be 2 to 100000", options->frames));
            options->json = t.json;
            compare(*options);
        }};
}

Command verify_command(CLI::App& app, Texts& t) {
    auto options = std::make_shared<VerifyOptions>();
    CLI::App* command = app.add_subcommand(
        "verify", "check on this device what Talus claims of its numbers, in a minute or two");
    command->add_option("--json", options->json, "write the findings, for a report")->type_name("FILE.json");
    command->add_option("--only", options->only, "this claim alone, may be repeated")->type_name("CLAIM");
    add_gpu(*command, t);
    return {command, [&t, options] {
                options->gpu = t.context();
                verify(*options);
            }};
}

Command convert_command(CLI::App& app, Texts& t) {
    auto options = std::make_shared<ConvertOptions>();
    CLI::App* command = app.add_subcommand("convert", "turn a heightmap into another format");
    command->add_option("IN", options->input)->required();
    command->add_option("OUT", options->output)->required();
    command->add_option("--layer", options->layer, "a layer, as run --layer");
    command
        ->add_option(
            "--for", options->kind,
            "unreal, unity or godot: samples and bytes as it takes them, and what to type there; mesh "
            "(.obj, .gltf, .glb) and 'normal map' (.png) are written so too")
        ->type_name("PROGRAM");
    command->add_option("--tiles", t.tiles,
                        "NxM: so many files east and south, which share their edge samples");
    command
        ->add_option(
            "--maps", options->maps,
            "names as of --layer, with commas between: each in a file of its own, OUT_NAME, and their "
            "ranges in OUT.json; with --for unreal, unity or godot as weights, unless --weights is 0")
        ->delimiter(',')
        ->type_name("NAME,…");
    command->add_option(
        "--weights", options->weight_bits,
        "8 or 16: maps as weights of so many bits, which sum to one with a map of the rest; 0: values");
    command->add_option("--mesh-error", options->mesh_error_m,
                        "error that a mesh is simplified to, metres, 1 unless given");
    add_import(*command, t);
    return {command, [&t, options] {
                options->import = t.import();
                options->range_m = t.range_m();
                if (!t.tiles.empty()) options->tiles = size_from(t.tiles, "--tiles");
                convert(*options);
            }};
}

Command tile_command(CLI::App& app, Texts& t) {
    auto options = std::make_shared<TileOptions>();
    auto generate = std::make_shared<std::string>();
    CLI::App* command = app.add_subcommand("tile",
                                           "write a raster of any size as a GeoTIFF in tiles with overviews, "
                                           "to be drawn without loading all of it");
    auto files = std::make_shared<std::vector<std::string>>();
    command
        ->add_option("FILES", *files,
                     "any raster that GDAL reads, mosaics (.vrt) too, and the GeoTIFF to write; that alone "
                     "with --generate")
        ->expected(1, 2)
        ->type_name("[IN] OUT.tif");
    auto photos = std::make_shared<std::vector<std::string>>();
    command
        ->add_option(
            "--texture", *photos,
            "any raster in colours that GDAL reads, and the GeoTIFF to write, for --texture of other "
            "commands; FILES may be left out then")
        ->expected(2)
        ->type_name("PHOTO OUT.tif");
    command->add_option("--generate", *generate,
                        "KIND,NXxNY: terrain of that many samples instead of IN, as terrain.kind has them");
    command->add_option("--seed", options->seed, "of generated terrain, 1 unless given");
    command->add_option("--relief", options->relief_m, "of generated terrain, in metres, 2000 unless given");
    command->add_option("--spacing", t.spacing, "metres between samples");
    command->add_option("--range", t.range,
                        "lo,hi: heights of the smallest and largest value of whole numbers that lie nowhere");
    return {
        command, [&t, options, files, photos, generate] {
            options->import = t.import();
            if (!photos->empty()) {
                options->photo = photos->front();
                options->photo_output = photos->back();
            }
            if (files->empty() && generate->empty() && !photos->empty()) return tile(*options);
            if (files->size() != (generate->empty() ? 2 : 1))
                throw Error("talus tile takes IN and OUT, --generate and OUT alone, or --texture PHOTO OUT");
            options->output = files->back();
            if (!generate->empty()) {
                const auto comma = generate->find(',');
                options->kind = generate->substr(0, comma);
                options->size =
                    size_from(comma == std::string::npos ? "" : generate->substr(comma + 1), "--generate");
            } else {
                options->input = files->front();
            }
            if (!(options->relief_m >= 0 && options->relief_m <= 1e5))
                throw Error(
                    fmt::format("--relief {} cannot be made, it must be 0 to 100000 m", options->relief_m));
            tile(*options);
        }};
}

Command put_back_command(CLI::App& app, Texts& t) {
    auto options = std::make_shared<PutBackOptions>();
    auto mosaic = std::make_shared<std::string>();
    CLI::App* command = app.add_subcommand(
        "put-back",
        "put a terrain that --window cut out of a raster back into its place: a patch beside the "
        "mosaic, and the mosaic over both; the raster stays as it is");
    command->add_option("FILE", options->document, "a document of such a terrain")->required();
    command->add_option("OUT.vrt", *mosaic, "the mosaic to write")->required();
    command->add_option(
        "--feather", t.feather,
        "metres from the cut-out's edges within which work fades into the raster; 0 unless given");
    command->add_flag("--though-changed", options->settings.though_changed,
                      "although the raster was changed since: what changed there within the part goes");
    return {command, [&t, options, mosaic] {
                options->settings.mosaic = *mosaic;
                if (!t.feather.empty())
                    options->settings.feather_m = numbers("--feather", t.feather, ',', 1)[0];
                put_back(*options);
            }};
}

Command replay_command(CLI::App& app, Texts& t) {
    auto options = std::make_shared<ReplayOptions>();
    CLI::App* command = app.add_subcommand("replay", "do again what a journal recorded");
    command->add_option("FILE", options->journal)->required();
    command->add_option("--size", t.size, "NXxNY: the same scene with so many samples");
    add_outputs(*command, t, options->outputs);
    add_gpu(*command, t);
    return {command, [&t, options] {
                options->gpu = t.context();
                if (!t.size.empty()) options->size = size_from(t.size);
                options->outputs.json = t.json;
                replay(*options);
            }};
}

Command info_command(CLI::App& app, Texts& t) {
    CLI::App* command = app.add_subcommand("info", "say what a file holds");
    command->add_option("FILE", t.file)->required();
    command->add_flag("--json", t.json, "as JSON");
    add_import(*command, t);
    return {command, [&t] { info(t.file, t.import(), t.json); }};
}

Command presets_command(CLI::App& app, Texts& t) {
    CLI::App* command = app.add_subcommand("presets", "list the built-in scenes");
    command->add_flag("--json", t.json, "as JSON");
    return {command, [&t] { list_presets(t.json); }};
}

Command parameters_command(CLI::App& app, Texts& t) {
    CLI::App* command = app.add_subcommand("parameters", "list every parameter with unit, range and help");
    command->add_flag("--json", t.json, "as JSON");
    return {command, [&t] { list_parameters(t.json); }};
}

Command why_no_window_command(CLI::App& app, Texts& /*t*/) {
    CLI::App* command =
        app.add_subcommand("why-no-window", "say why no window can open here; exit code 0 when one can");
    return {command, [] {
                const std::string reason = why_no_window();
                if (!reason.empty()) throw Error(reason);
            }};
}

// Without a command: the window.
Command window_command(CLI::App& app, Texts& t) {
    auto options = std::make_shared<WindowOptions>();
    app.add_option("FILE", t.file, "heightmap, Talus document or scene (.toml) to open in the window");
    app.add_option("--preset", t.preset, "scene to start from, a name or a .toml file");
    app.add_option("--set", t.assignments, "section.name=value, may be repeated");
    add_texture(app, t);
    add_tiled(app, t);
    app.add_option("--journal", options->journal, "write what was done here when the window closes");
    app.add_option("--window-size", t.window_size,
                   "WxH pixels; unless given, as it was when it was last closed");
    app.add_option("--ui-scale", options->ui_scale,
                   "size of panels and text, 0.5 to 4; as the display asks for")
        ->check(CLI::Range(0.5, 4.0));
    std::vector<std::string> theme_names;
    for (const Theme& one : themes()) theme_names.emplace_back(one.name);
    app.add_option("--theme", options->theme, "colours of the panels; as they were when it was last closed")
        ->check(CLI::IsMember(theme_names));
    app.add_option("--frame-log", options->frame_log, "write what every frame took")->type_name("FILE.csv");
    app.add_option("--ui-rects", options->ui_rects, "keep in this file where every named widget is")
        ->type_name("FILE");
    add_import(app, t);
    app.add_option("--shader-dir", t.shader_dir, "read shaders from this folder and follow its changes");
    return {&app, [&t, options] {
                options->scene = t.scene(t.file);
                if (t.tiled && t.file.empty())
                    throw Error("--tiled says how a file is shown: give a FILE too");
                // At once, and not when the file has been measured.
                if (is_in_tiles(options->scene)) check_tiled_request(options->scene);
                if (!options->journal.empty() && is_in_tiles(options->scene))
                    throw Error(fmt::format(
                        "--journal {} cannot be written: '{}' is in tiles and can only be looked at",
                        options->journal, t.file));
                if (!t.window_size.empty()) {
                    options->size = size_from(t.window_size, "--window-size");
                    if (glm::any(glm::lessThan(*options->size, glm::ivec2(320))) ||
                        glm::any(glm::greaterThan(*options->size, glm::ivec2(16384))))
                        throw Error(fmt::format(
                            "--window-size {} cannot be opened, it must be 320x320 to 16384x16384",
                            t.window_size));
                }
                run_window(*options);
            }};
}

int parse_and_do(int argc, char** argv) {
    CLI::App app("Talus: the sandbox for terrain whose ground moves.", "talus");
    app.set_version_flag("--version", "talus 0.1.0");
    Texts t;
    const Command window = window_command(app, t);
    std::vector<Command> commands;
    for (const auto make : {run_command, render_command, compare_command, verify_command, convert_command,
                            tile_command, put_back_command, replay_command, info_command, presets_command,
                            parameters_command, why_no_window_command})
        commands.push_back(make(app, t));
    try {
        app.parse(argc, argv);
    } catch (const CLI::Success& success) {
        return app.exit(success);
    } catch (const CLI::ParseError& error) {
        fmt::print(stderr, "talus: {}; 'talus --help' shows the command line\n", error.what());
        return 2;
    }
    if (!t.shader_dir.empty()) gpu::use_shader_folder(t.shader_dir);
    const auto asked = std::find_if(commands.begin(), commands.end(),
                                    [](const Command& command) { return command.parsed->parsed(); });
    (asked == commands.end() ? window : *asked).act();
    return 0;
}

}  // namespace

int command_line(int argc, char** argv) {
    try {
        return parse_and_do(argc, argv);
    } catch (const std::bad_alloc&) {
        fmt::print(stderr, "talus: not enough memory, use a smaller terrain\n");
    } catch (const std::exception& error) {
        fmt::print(stderr, "talus: {}\n", error.what());
    }
    return 1;
}

}  // namespace talus::app
