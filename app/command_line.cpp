#include "app/command_line.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <filesystem>

#include "app/commands/commands.h"
#include "app/core/report.h"
#include "app/window/glfw.h"
#include "app/window/window.h"
#include "sim/error.h"
#include "sim/gpu/shader_text.h"
#include "sim/io/heightmap_formats.h"
#include "sim/terrain/layers.h"

namespace talus::app {
namespace {

constexpr std::int64_t max_ticks = 1000000000;

std::vector<double> numbers(const std::string& option, const std::string& text, char separator,
                            std::size_t count) {
    std::vector<double> values;
    const char* at = text.data();
    const char* end = at + text.size();
    while (at <= end && values.size() < count) {
        double value = 0;
        const auto [next, error] = std::from_chars(at, end, value);
        if (error != std::errc() || (next != end && *next != separator)) break;
        values.push_back(value);
        at = next + 1;
    }
    const bool finite =
        std::all_of(values.begin(), values.end(), [](double v) { return std::abs(v) <= 1e12; });
    if (values.size() != count || at != end + 1 || !finite)
        throw Error(fmt::format("{} '{}' cannot be read, write it as {} numbers with '{}' between", option,
                                text, count, separator));
    return values;
}

glm::ivec2 size_from(const std::string& text, const char* option = "--size") {
    const std::vector<double> v = numbers(option, text, 'x', 2);
    if (v[0] != std::floor(v[0]) || v[1] != std::floor(v[1]) || std::abs(v[0]) > 1e6 || std::abs(v[1]) > 1e6)
        throw Error(
            fmt::format("{} '{}' cannot be read, write it as two whole numbers, e.g. 513x513", option, text));
    return {v[0], v[1]};
}

// Texts as they stand on the command line, read after parsing so that errors are ours.
struct Texts {
    std::string file, preset, input, size, spacing, range, raw, eye, target, fov, method, view, shader_dir,
        layer, samples, tolerances, texture, window_size, tiles;
    std::vector<std::string> assignments, gauges, springs;
    std::optional<int> gpu;
    bool require_hardware = false;
    bool json = false;

    gpu::ContextChoice context() const { return {gpu, require_hardware}; }
    io::ImportSettings import() const {
        io::ImportSettings settings;
        if (!spacing.empty()) {
            settings.spacing_m = numbers("--spacing", spacing, ',', 1)[0];
            if (!(*settings.spacing_m > 0))
                throw Error(fmt::format("--spacing {} cannot be used, it must be positive", spacing));
        }
        if (!range.empty()) settings.range_m = range_m();
        if (!raw.empty()) settings.raw = io::parse_raw_layout(raw);
        return settings;
    }
    std::optional<glm::dvec2> range_m() const {
        if (range.empty()) return std::nullopt;
        const std::vector<double> v = numbers("--range", range, ',', 2);
        if (!(v[1] > v[0]))
            throw Error(
                fmt::format("--range {} cannot be used, its first height must be the lower one", range));
        return glm::dvec2(v[0], v[1]);
    }
    std::optional<glm::dvec3> point(const char* option, const std::string& text) const {
        if (text.empty()) return std::nullopt;
        const std::vector<double> v = numbers(option, text, ',', 3);
        return glm::dvec3(v[0], v[1], v[2]);
    }
    SceneRequest scene(const std::string& file_given) const {
        SceneRequest request;
        request.preset = preset;
        request.input = file_given;
        request.import = import();
        request.assignments = assignments;
        request.texture = texture;
        if (!method.empty()) request.assignments.push_back("render.method=" + method);
        if (!view.empty()) request.assignments.push_back("render.view=" + view);
        if (!fov.empty()) request.assignments.push_back("camera.fov_deg=" + fov);
        return request;
    }
};

void add_gpu(CLI::App& app, Texts& t) {
    app.add_option("--gpu", t.gpu, "use the N-th device, hardware first (0 is the first)");
    app.add_flag("--require-hardware", t.require_hardware, "refuse software renderers");
    app.add_option("--shader-dir", t.shader_dir, "read shaders from this folder and follow its changes");
}
void add_texture(CLI::App& app, Texts& t) {
    app.add_option("--texture", t.texture,
                   "a picture draped over the terrain, its edges on the outer samples")
        ->type_name("PICTURE");
}
void add_import(CLI::App& app, Texts& t) {
    app.add_option("--spacing", t.spacing, "metres between samples");
    app.add_option("--range", t.range, "lo,hi: heights of the file's smallest and largest value, in metres");
    app.add_option("--raw", t.raw, "NXxNY[,big][,bottom]: how a raw file's samples lie");
}
void add_outputs(CLI::App& app, Texts& t, Outputs& outputs) {
    app.add_option("--out", outputs.files,
                   fmt::format("write the terrain: {}; .exr is a document; may be repeated",
                               fmt::join(io::writable_endings(), ", ")))
        ->type_name("FILE");
    app.add_option("--image", outputs.image, "write a picture")->type_name("FILE.png");
    app.add_option("--report", outputs.report, "write the report")->type_name("FILE.json");
    app.add_option("--journal", outputs.journal, "write what was done, for 'talus replay'")
        ->type_name("FILE.journal");
    app.add_option("--layer", outputs.layer,
                   fmt::format("what single-layer outputs hold: {}", fmt::join(output_names(), ", ")));
    app.add_flag("--json", t.json, "print the report");
}

int parse_and_do(int argc, char** argv) {
    CLI::App app("Talus: the sandbox for terrain whose ground moves.", "talus");
    app.set_version_flag("--version", "talus 0.1.0");
    Texts t;
    RunOptions run_options;
    ReplayOptions replay_options;
    RenderOptions render_options;
    CompareOptions compare_options;
    ConvertOptions convert_options;
    VerifyOptions verify_options;
    WindowOptions window_options;

    app.add_option("FILE", t.file, "heightmap or Talus document to open in the window");
    app.add_option("--preset", t.preset, "scene to start from, a name or a .toml file");
    app.add_option("--set", t.assignments, "section.name=value, may be repeated");
    add_texture(app, t);
    app.add_option("--journal", window_options.journal, "write what was done here when the window closes");
    app.add_option("--window-size", t.window_size,
                   "WxH pixels; unless given, as it was when it was last closed");
    app.add_option("--ui-scale", window_options.ui_scale,
                   "size of panels and text, 0.5 to 4; as the display asks for")
        ->check(CLI::Range(0.5, 4.0));
    app.add_option("--frame-log", window_options.frame_log, "write what every frame took")
        ->type_name("FILE.csv");
    app.add_option("--ui-rects", window_options.ui_rects, "keep in this file where every named widget is")
        ->type_name("FILE");
    add_import(app, t);
    app.add_option("--shader-dir", t.shader_dir, "read shaders from this folder and follow its changes");

    CLI::App* run_command = app.add_subcommand("run", "run a scene without a window");
    run_command->add_option("--preset", t.preset, "a name ('talus presets' lists them) or a .toml file");
    run_command->add_option("--in", t.input, "start from this heightmap or document");
    run_command->add_option("--size", t.size, "NXxNY samples of generated terrain");
    auto* ticks = run_command->add_option("--ticks", run_options.ticks, "how many ticks to run");
    run_command->add_option("--time", run_options.time_s, "how many seconds to simulate")->excludes(ticks);
    run_command->add_option("--set", t.assignments, "section.name=value, may be repeated");
    run_command
        ->add_option("--gauge", t.gauges, "X,Y in metres: write the water there every tick; may be repeated")
        ->allow_extra_args(false);
    run_command
        ->add_option("--gauges", run_options.gauge_table, "the table for them, gauges.csv unless given")
        ->type_name("FILE.csv");
    run_command->add_option("--spring", t.springs, "X,Y,RATE: a spring, metres and m³/s; may be repeated")
        ->allow_extra_args(false);
    add_texture(*run_command, t);
    add_import(*run_command, t);
    add_outputs(*run_command, t, run_options.outputs);
    add_gpu(*run_command, t);

    CLI::App* render_command = app.add_subcommand("render", "draw a terrain without a window");
    render_command->add_option("FILE", t.file, "heightmap or document")->required();
    render_command->add_option("--image", render_options.image, "the picture")->type_name("OUT.png");
    render_command->add_option("--keys", render_options.keys, "fly along the key cameras of this file")
        ->type_name("FILE.toml");
    render_command->add_option("--frames", render_options.frames,
                               "how many frames along the keys, 120 unless given");
    render_command->add_option("--turntable", render_options.turntable,
                               "so many frames once around the terrain");
    render_command->add_option("--size", t.size, "WxH pixels, 1280x720 unless given; to 32768 a side");
    render_command->add_option("--eye", t.eye, "x,y,z in metres: east, north, up from the south-west sample");
    render_command->add_option("--target", t.target, "x,y,z in metres");
    render_command->add_option("--fov", t.fov, "vertical field of view in degrees");
    render_command->add_option("--method", t.method, "how the surface is drawn");
    render_command->add_option("--view", t.view, "what the colours show; 'talus parameters' lists the views");
    render_command->add_option("--set", t.assignments, "section.name=value, may be repeated");
    add_texture(*render_command, t);
    render_command->add_option("--depth", render_options.depth, "metres along each pixel's ray")
        ->type_name("OUT.exr");
    render_command->add_option("--report", render_options.report, "write the report")->type_name("FILE.json");
    render_command->add_flag("--json", t.json, "print the report");
    add_import(*render_command, t);
    add_gpu(*render_command, t);

    CLI::App* compare_command =
        app.add_subcommand("compare", "measure methods of drawing against the double-precision reference");
    compare_command->add_option("FILE", t.file, "heightmap or document");
    compare_command->add_option("--preset", t.preset, "generate the terrain of this preset instead");
    compare_command->add_option("--samples", t.samples, "NXxNY samples of generated terrain");
    compare_command->add_option("--method", compare_options.methods,
                                "a method, may be repeated; all unless given");
    compare_command->add_option("--tolerance", t.tolerances,
                                "a,b,c: pixels that hybrid may err, 0,0.5,2 unless given");
    compare_command->add_option("--size", t.size, "WxH pixels, 480x270 unless given");
    compare_command->add_option("--keys", compare_options.keys, "fly along the key cameras of this file")
        ->type_name("FILE.toml");
    compare_command->add_option("--frames", compare_options.frames, "how many frames along the keys");
    compare_command->add_option("--limit", compare_options.limit_px, "pixels to look for a ray that agrees");
    compare_command->add_option("--report", compare_options.report, "write the report")
        ->type_name("FILE.json");
    compare_command->add_flag("--json", t.json, "print the report");
    add_import(*compare_command, t);
    add_gpu(*compare_command, t);

    CLI::App* verify_command = app.add_subcommand(
        "verify", "check on this device what Talus claims of its numbers, in a minute or two");
    verify_command->add_option("--json", verify_options.json, "write the findings, for a report")
        ->type_name("FILE.json");
    verify_command->add_option("--only", verify_options.only, "this claim alone, may be repeated")
        ->type_name("CLAIM");
    add_gpu(*verify_command, t);

    CLI::App* convert_command = app.add_subcommand("convert", "turn a heightmap into another format");
    convert_command->add_option("IN", convert_options.input)->required();
    convert_command->add_option("OUT", convert_options.output)->required();
    convert_command->add_option("--layer", convert_options.layer, "a layer, as run --layer");
    convert_command
        ->add_option(
            "--for", convert_options.kind,
            "unreal, unity or godot: samples and bytes as it takes them, and what to type there; mesh "
            "(.obj) and 'normal map' (.png) are written so too")
        ->type_name("PROGRAM");
    convert_command->add_option("--tiles", t.tiles,
                                "NxM: so many files east and south, which share their edge samples");
    convert_command->add_option("--mesh-error", convert_options.mesh_error_m,
                                "error that a mesh is simplified to, metres, 1 unless given");
    add_import(*convert_command, t);

    CLI::App* replay_command = app.add_subcommand("replay", "do again what a journal recorded");
    replay_command->add_option("FILE", replay_options.journal)->required();
    replay_command->add_option("--size", t.size, "NXxNY: the same scene with so many samples");
    add_outputs(*replay_command, t, replay_options.outputs);
    add_gpu(*replay_command, t);

    CLI::App* info_command = app.add_subcommand("info", "say what a file holds");
    info_command->add_option("FILE", t.file)->required();
    info_command->add_flag("--json", t.json, "as JSON");
    add_import(*info_command, t);

    CLI::App* presets_command = app.add_subcommand("presets", "list the built-in scenes");
    presets_command->add_flag("--json", t.json, "as JSON");
    CLI::App* parameters_command =
        app.add_subcommand("parameters", "list every parameter with unit, range and help");
    parameters_command->add_flag("--json", t.json, "as JSON");
    CLI::App* window_command =
        app.add_subcommand("why-no-window", "say why no window can open here; exit code 0 when one can");

    try {
        app.parse(argc, argv);
    } catch (const CLI::Success& success) {
        return app.exit(success);
    } catch (const CLI::ParseError& error) {
        fmt::print(stderr, "talus: {}; 'talus --help' shows the command line\n", error.what());
        return 2;
    }
    if (!t.shader_dir.empty()) gpu::use_shader_folder(t.shader_dir);

    if (run_command->parsed()) {
        run_options.gpu = t.context();
        run_options.scene = t.scene(t.input);
        if (!t.size.empty()) run_options.scene.size = size_from(t.size);
        if (run_options.ticks && (*run_options.ticks < 0 || *run_options.ticks > max_ticks))
            throw Error(
                fmt::format("--ticks {} cannot be run, it must be 0 to {}", *run_options.ticks, max_ticks));
        if (run_options.time_s && !(*run_options.time_s >= 0 && *run_options.time_s < 1e15))
            throw Error(
                fmt::format("--time {} cannot be run, it must be 0 or more seconds", *run_options.time_s));
        for (const std::string& text : t.gauges) {
            const std::vector<double> v = numbers("--gauge", text, ',', 2);
            run_options.gauges.emplace_back(v[0], v[1]);
        }
        for (const std::string& text : t.springs) {
            const std::vector<double> v = numbers("--spring", text, ',', 3);
            run_options.springs.push_back({v[0], v[1], v[2]});
        }
        run_options.outputs.json = t.json;
        run(run_options);
    } else if (render_command->parsed()) {
        render_options.gpu = t.context();
        render_options.scene = t.scene(t.file);
        if (!t.size.empty()) render_options.size = size_from(t.size);
        render_options.eye = t.point("--eye", t.eye);
        render_options.target = t.point("--target", t.target);
        render_options.json = t.json;
        if (render_options.frames < 2 || render_options.frames > 100000 || render_options.turntable < 0 ||
            render_options.turntable > 100000)
            throw Error("--frames and --turntable cannot be drawn, they must be 2 to 100000");
        render(render_options);
    } else if (compare_command->parsed()) {
        compare_options.gpu = t.context();
        compare_options.scene = t.scene(t.file);
        if (!t.samples.empty()) compare_options.scene.size = size_from(t.samples, "--samples");
        if (!t.size.empty()) compare_options.size = size_from(t.size);
        if (!t.tolerances.empty()) {
            const auto count = 1 + std::count(t.tolerances.begin(), t.tolerances.end(), ',');
            compare_options.tolerances_px =
                numbers("--tolerance", t.tolerances, ',', static_cast<std::size_t>(count));
        }
        for (const double tolerance : compare_options.tolerances_px)
            if (!(tolerance >= 0 && tolerance <= 16))
                throw Error(
                    fmt::format("--tolerance {} cannot be compared, it must be 0 to 16 pixels", tolerance));
        if (!(compare_options.limit_px > 0 && compare_options.limit_px <= 64))
            throw Error(fmt::format("--limit {} cannot be used, it must be above 0 and at most 64 pixels",
                                    compare_options.limit_px));
        if (compare_options.frames < 2 || compare_options.frames > 100000)
            throw Error(
                fmt::format("--frames {} cannot be flown, it must be 2 to 100000", compare_options.frames));
        compare_options.json = t.json;
        compare(compare_options);
    } else if (verify_command->parsed()) {
        verify_options.gpu = t.context();
        verify(verify_options);
    } else if (convert_command->parsed()) {
        convert_options.import = t.import();
        convert_options.range_m = t.range_m();
        if (!t.tiles.empty()) convert_options.tiles = size_from(t.tiles, "--tiles");
        convert(convert_options);
    } else if (replay_command->parsed()) {
        replay_options.gpu = t.context();
        if (!t.size.empty()) replay_options.size = size_from(t.size);
        replay_options.outputs.json = t.json;
        replay(replay_options);
    } else if (info_command->parsed()) {
        info(t.file, t.import(), t.json);
    } else if (presets_command->parsed()) {
        list_presets(t.json);
    } else if (parameters_command->parsed()) {
        list_parameters(t.json);
    } else if (window_command->parsed()) {
        const std::string reason = why_no_window();
        if (!reason.empty()) throw Error(reason);
    } else {
        window_options.scene = t.scene(t.file);
        if (!t.window_size.empty()) {
            window_options.size = size_from(t.window_size, "--window-size");
            if (glm::any(glm::lessThan(*window_options.size, glm::ivec2(320))) ||
                glm::any(glm::greaterThan(*window_options.size, glm::ivec2(16384))))
                throw Error(fmt::format(
                    "--window-size {} cannot be opened, it must be 320x320 to 16384x16384", t.window_size));
        }
        run_window(window_options);
    }
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
