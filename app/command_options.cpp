#include "app/command_options.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

#include "app/core/scene_file.h"
#include "sim/error.h"
#include "sim/io/heightmap_formats.h"
#include "sim/terrain/layers.h"

namespace talus::app {

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

glm::ivec2 size_from(const std::string& text, const char* option) {
    const std::vector<double> v = numbers(option, text, 'x', 2);
    if (v[0] != std::floor(v[0]) || v[1] != std::floor(v[1]) || std::abs(v[0]) > 1e6 || std::abs(v[1]) > 1e6)
        throw Error(
            fmt::format("{} '{}' cannot be read, write it as two whole numbers, e.g. 513x513", option, text));
    return {v[0], v[1]};
}

io::ImportSettings Texts::import() const {
    io::ImportSettings settings;
    if (!spacing.empty()) {
        settings.spacing_m = numbers("--spacing", spacing, ',', 1)[0];
        if (!(*settings.spacing_m > 0))
            throw Error(fmt::format("--spacing {} cannot be used, it must be positive", spacing));
    }
    if (!range.empty()) settings.range_m = range_m();
    if (!raw.empty()) settings.raw = io::parse_raw_layout(raw);
    if (!window.empty()) {
        const std::vector<double> v = numbers("--window", window, ',', 4);
        settings.window = io::FileWindow{v[0], v[1], v[2], v[3]};
        if (!raw.empty())
            throw Error(
                "--window cuts a part out of a raster, and --raw reads a file of another kind: leave one "
                "out");
        if (tiled)
            throw Error(
                "--tiled shows the whole file, and --window cuts a part out of it: leave one of the two out");
    }
    return settings;
}

std::optional<glm::dvec2> Texts::range_m() const {
    if (range.empty()) return std::nullopt;
    const std::vector<double> v = numbers("--range", range, ',', 2);
    if (!(v[1] > v[0]))
        throw Error(fmt::format("--range {} cannot be used, its first height must be the lower one", range));
    return glm::dvec2(v[0], v[1]);
}

std::optional<glm::dvec3> point_from(const char* option, const std::string& text) {
    if (text.empty()) return std::nullopt;
    const std::vector<double> v = numbers(option, text, ',', 3);
    return glm::dvec3(v[0], v[1], v[2]);
}

std::pair<std::string, std::string> named_file(const std::string& option, const std::string& text,
                                               const std::string& example) {
    const auto equals = text.find('=');
    if (equals == 0 || equals == std::string::npos || equals + 1 == text.size())
        throw Error(fmt::format("{} '{}' cannot be read, write it as {}", option, text, example));
    return {text.substr(0, equals), text.substr(equals + 1)};
}

SceneRequest Texts::scene(const std::string& file_given) const {
    SceneRequest request;
    request.preset = preset;
    request.input = file_given;
    if (is_scene(file_given)) {
        if (!preset.empty())
            throw Error(fmt::format("'{}' is a scene and --preset {} is another: leave one of the two out",
                                    file_given, preset));
        if (!window.empty() || !raw.empty() || !range.empty())
            throw Error(fmt::format(
                "'{}' is a scene, which generates its terrain: leave out --window, --raw and --range",
                file_given));
        request.preset = std::exchange(request.input, "");
    }
    request.import = import();
    if (request.import.window && file_given.empty())
        throw Error("--window cuts a part out of a file: name the file too");
    request.assignments = assignments;
    request.texture = texture;
    request.tiled = tiled;
    if (!method.empty()) request.assignments.push_back("render.method=" + method);
    if (!view.empty()) request.assignments.push_back("render.view=" + view);
    if (!fov.empty()) request.assignments.push_back("camera.fov_deg=" + fov);
    return request;
}

void add_tiled(CLI::App& app, Texts& t) {
    app.add_flag(
        "--tiled", t.tiled,
        "show the file in tiles, as mosaics (.vrt) and rasters of more than 8192 samples a side are anyway");
}

void add_gpu(CLI::App& app, Texts& t) {
    app.add_option("--gpu", t.gpu, "use the N-th device, hardware first (0 is the first)");
    app.add_flag("--require-hardware", t.require_hardware, "refuse software renderers");
    app.add_option("--shader-dir", t.shader_dir, "read shaders from this folder and follow its changes");
}
void add_texture(CLI::App& app, Texts& t) {
    app.add_option("--texture", t.texture,
                   "a picture over the terrain: where it lies on Earth, or stretched over all of it")
        ->type_name("PICTURE");
}
void add_import(CLI::App& app, Texts& t) {
    app.add_option("--spacing", t.spacing, "metres between samples");
    app.add_option("--range", t.range, "lo,hi: heights of the file's smallest and largest value, in metres");
    app.add_option("--raw", t.raw, "NXxNY[,big][,bottom]: how a raw file's samples lie");
    app.add_option("--window", t.window,
                   "W,S,E,N: the part of a raster of any size to work in, in the file's coordinates; in "
                   "metres from its south-west sample where it has none");
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

}  // namespace talus::app
