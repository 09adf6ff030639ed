#include "sim/io/document.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <utility>

#include "sim/drives.h"
#include "sim/error.h"
#include "sim/events.h"
#include "sim/io/endings.h"
#include "sim/io/picture.h"
#include "sim/terrain/bed_beyond.h"
#include "sim/terrain/layers.h"
#include "sim/terrain/springs.h"

namespace talus::io {
namespace {

namespace fs = std::filesystem;

constexpr const char* bed_beyond_attribute = "talus:bed_beyond";
constexpr const char* drives_attribute = "talus:drives";
constexpr const char* events_attribute = "talus:events";
constexpr const char* workspace_attribute = "talus:workspace";
// The start that a difference counts from, of two words.
constexpr std::array<const char*, 2> start_channels = {"start", "start_low"};

// x, y and rate of each, as save_document writes them.
std::vector<Spring> springs_from(const fs::path& path, const std::string& text) {
    std::vector<Spring> springs;
    std::istringstream words(text);
    std::vector<double> numbers;
    for (double number = 0; words >> number;) numbers.push_back(number);
    if (!words.eof() || numbers.size() % 3 != 0)
        throw Error(fmt::format("'{}' holds springs '{}', each must be three numbers: x, y and rate",
                                path.string(), text));
    for (std::size_t i = 0; i < numbers.size(); i += 3)
        springs.push_back({numbers[i], numbers[i + 1], numbers[i + 2]});
    return springs;
}

// A line each: the parameter, then its table, as save_document writes them.
std::vector<Drive> drives_from(const fs::path& path, const std::string& text) {
    std::vector<Drive> drives;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        const auto space = line.find(' ');
        try {
            if (space == std::string::npos) throw Error(fmt::format("'{}' has no table", line));
            drives.push_back({line.substr(0, space), series_from_text(line.substr(space + 1))});
        } catch (const Error& error) {
            throw Error(
                fmt::format("'{}': its attribute {}: {}", path.string(), drives_attribute, error.what()));
        }
    }
    return drives;
}

// Channels of a number: its word, or its two. No dots in their names: Blender takes a file with one for
// layers of a render and shows nothing of it.
std::vector<std::string> channels_of(const LayerNumber& number) {
    if (number.two_words) return {number.name, number.name + "_low"};
    return {number.name};
}

std::vector<std::string> channels_of(const LayerDescription& layer) {
    std::vector<std::string> channels;
    for (const LayerNumber& number : layer.numbers)
        for (const std::string& channel : channels_of(number)) channels.push_back(channel);
    return channels;
}

// One channel's values; empty: the file has none of this name. Throws talus::Error.
std::vector<float> read_channel(const fs::path& path, OIIO::ImageInput& input, const std::string& name) {
    const OIIO::ImageSpec& spec = input.spec();
    const int channel = spec.channelindex(name);
    if (channel < 0) return {};
    std::vector<float> values(static_cast<std::size_t>(spec.width) * spec.height);
    if (!input.read_image(0, 0, channel, channel + 1, OIIO::TypeDesc::FLOAT, values.data()))
        throw Error(fmt::format("'{}' cannot be read: {}", path.string(), input.geterror()));
    if (!std::all_of(values.begin(), values.end(), [](float value) { return std::isfinite(value); }))
        throw Error(fmt::format("'{}' holds samples in channel '{}' that are not finite numbers",
                                path.string(), name));
    return values;
}

// A layer is there where the file has a channel of it. Throws talus::Error for samples that no run could
// leave.
void read_layer(const fs::path& path, OIIO::ImageInput& input, const LayerDescription& layer,
                TerrainState& state) {
    const auto words_a_texel = static_cast<std::size_t>(layer.words());
    if (!layer.is_optional()) make_layer(state, layer, state.grid.count());
    std::size_t word = 0;
    const auto take = [&](const std::string& channel) {
        const std::vector<float> values = read_channel(path, input, channel);
        if (values.empty()) return;
        if (words_of(state, layer).empty()) make_layer(state, layer, state.grid.count());
        const std::span<float> words = words_of(state, layer);
        for (std::size_t i = 0; i < values.size(); ++i) words[i * words_a_texel + word] = values[i];
    };
    for (const LayerNumber& number : layer.numbers) {
        if (!number.other_name.empty()) take(number.other_name);
        for (const std::string& channel : channels_of(number)) {
            take(channel);
            ++word;
        }
    }
    const std::span<const float> words = words_of(std::as_const(state), layer);
    for (std::size_t at = 0; layer.refusal && at < words.size(); at += words_a_texel) {
        const std::string refusal = layer.refusal(words.subspan(at, words_a_texel));
        if (!refusal.empty()) throw Error(fmt::format("'{}' holds {}", path.string(), refusal));
    }
}

// The ground beyond the edges, as save_document writes it. Throws talus::Error.
void read_bed_beyond(const fs::path& path, const OIIO::ImageSpec& spec, TerrainState& state) {
    const OIIO::ParamValue* words = spec.find_attribute(bed_beyond_attribute);
    if (!words) return;
    const OIIO::TypeDesc type = words->type();
    if (type.basetype != OIIO::TypeDesc::FLOAT)
        throw Error(
            fmt::format("'{}': its attribute {} must be floats", path.string(), bed_beyond_attribute));
    const auto* first = static_cast<const float*>(words->data());
    state.bed_beyond.assign(first, first + type.basevalues());
    try {
        check_bed_beyond(state);
    } catch (const Error& error) {
        throw Error(fmt::format("'{}': {}", path.string(), error.what()));
    }
}

// What a terrain was cut out of may have been moved with its document.
std::optional<CutOut> cut_out_told(const fs::path& path, const OIIO::ImageSpec& spec) {
    const std::string text = spec.get_string_attribute("talus:cut_out");
    if (text.empty()) return std::nullopt;
    CutOut cut_out = cut_out_from(path, text);
    std::error_code ignored;
    const fs::path beside = fs::absolute(path).parent_path() / cut_out.path.filename();
    if (!fs::exists(cut_out.path, ignored) && fs::exists(beside, ignored)) cut_out.path = beside;
    return cut_out;
}

void read_start(const fs::path& path, OIIO::ImageInput& input, TerrainState& state) {
    const std::vector<float> high = read_channel(path, input, start_channels[0]);
    const std::vector<float> low = read_channel(path, input, start_channels[1]);
    if (high.empty() || low.empty()) return;
    state.start.reserve(high.size());
    for (std::size_t i = 0; i < high.size(); ++i) state.start.emplace_back(high[i], low[i]);
}

Document read_document(const fs::path& path, const ImportSettings& settings) {
    const auto input = open_picture(path);
    check_file_size(path, input->spec().width, input->spec().height);
    const OIIO::ImageSpec spec = input->spec();
    Document document;
    document.kind = "Talus document";
    TerrainState& state = document.state;
    state.grid = {spec.width, spec.height, number_attribute(path, spec, "talus:dx_m", 1),
                  number_attribute(path, spec, "talus:dy_m", 1)};
    if (settings.spacing_m) state.grid.dx = state.grid.dy = *settings.spacing_m;
    check_grid(state.grid);
    state.clock.ticks =
        static_cast<std::int64_t>(std::clamp(number_attribute(path, spec, "talus:ticks", 0), 0.0, 1e15));
    state.clock.simulated_s = number_attribute(path, spec, "talus:simulated_s", 0);
    state.edges_since_s = number_attribute(path, spec, "talus:edges_since_s", 0);
    document.parameters = spec.get_string_attribute("talus:parameters");
    document.workspace = spec.get_string_attribute(workspace_attribute);
    const std::string transform = spec.get_string_attribute("talus:geotransform");
    if (!transform.empty()) {
        Georeference georeference;
        georeference.wkt = spec.get_string_attribute("talus:crs");
        std::array<double, 6>& t = georeference.transform;
        if (std::sscanf(transform.c_str(), "%lf %lf %lf %lf %lf %lf", &t[0], &t[1], &t[2], &t[3], &t[4],
                        &t[5]) == 6)
            document.state.georeference = georeference;
    }
    document.cut_out = cut_out_told(path, spec);
    for (const LayerDescription& layer : layers()) read_layer(path, *input, layer, state);
    read_start(path, *input, state);
    read_bed_beyond(path, spec, state);
    state.springs = springs_from(path, spec.get_string_attribute("talus:springs"));
    for (const Spring& spring : state.springs) check_spring(state.grid, spring);
    state.drives = drives_from(path, spec.get_string_attribute(drives_attribute));
    try {
        state.events = events_from_text(spec.get_string_attribute(events_attribute));
    } catch (const Error& error) {
        throw Error(fmt::format("'{}': its attribute {}: {}", path.string(), events_attribute, error.what()));
    }
    return document;
}

void check_not_a_document(const fs::path& path) {
    if (is_document(path))
        throw Error(
            fmt::format("'{}' is a Talus document, and --window cuts a part out of a raster: leave "
                        "--window out, or crop it in the Map panel",
                        path.string()));
}

}  // namespace

bool is_document(const fs::path& path) {
    if (ending_of(path) != ".exr") return false;
    std::error_code ignored;
    if (!fs::is_regular_file(path, ignored) || fs::file_size(path, ignored) == 0) return false;
    return open_picture(path)->spec().channelindex("bedrock") >= 0;
}

Document open_document(const fs::path& path, const ImportSettings& settings) {
    Document document;
    Heightmap heightmap;
    std::vector<float> bed_beyond;
    if (settings.window) {
        check_not_a_document(path);
        CutOutHeights part = cut_out_heights(path, settings);
        heightmap = std::move(part.heightmap);
        document.cut_out = std::move(part.cut_out);
        bed_beyond = std::move(part.bed_beyond);
    } else if (is_document(path)) {
        return read_document(path, settings);
    } else {
        heightmap = read_heightmap(path, settings);
    }
    document.state = bedrock_terrain(heightmap.grid, heightmap.heights);
    document.state.bed_beyond = std::move(bed_beyond);
    document.state.georeference = std::move(heightmap.georeference);
    document.kind = std::move(heightmap.kind);
    document.notes = std::move(heightmap.notes);
    return document;
}

void save_document(const fs::path& path, const Document& document) {
    const TerrainState& state = document.state;
    // The ground first: it is what picture programs show.
    std::vector<std::string> names = {"Y"};
    for (const LayerDescription& layer : layers())
        if (!words_of(state, layer).empty())
            for (const std::string& channel : channels_of(layer)) names.push_back(channel);
    // Most often the ground has changed since; where it has not, there is nothing to keep.
    const bool keeps_start = !state.start.empty() && state.start != state.ground_words();
    if (keeps_start) names.insert(names.end(), start_channels.begin(), start_channels.end());
    OIIO::ImageSpec spec(state.grid.nx, state.grid.ny, static_cast<int>(names.size()), OIIO::TypeDesc::FLOAT);
    spec.channelnames = names;
    spec.attribute("compression", "zip");
    spec.attribute("talus:document", "1");
    spec.attribute("talus:dx_m", fmt::format("{}", state.grid.dx));
    spec.attribute("talus:dy_m", fmt::format("{}", state.grid.dy));
    spec.attribute("talus:ticks", fmt::format("{}", state.clock.ticks));
    spec.attribute("talus:simulated_s", fmt::format("{}", state.clock.simulated_s));
    std::string springs;
    for (const Spring& spring : state.springs)
        springs += fmt::format("{} {} {} ", spring.x_m, spring.y_m, spring.rate_m3_per_s);
    if (state.edges_since_s != 0)
        spec.attribute("talus:edges_since_s", fmt::format("{}", state.edges_since_s));
    if (!springs.empty()) spec.attribute("talus:springs", springs);
    std::string drives;
    for (const Drive& drive : state.drives)
        drives += fmt::format("{} {}\n", drive.parameter, to_text(drive.series));
    if (!drives.empty()) spec.attribute(drives_attribute, drives);
    if (!state.events.empty()) spec.attribute(events_attribute, to_text(state.events));
    if (!document.parameters.empty()) spec.attribute("talus:parameters", document.parameters);
    if (!document.workspace.empty()) spec.attribute(workspace_attribute, document.workspace);
    if (document.state.georeference) {
        const auto& t = document.state.georeference->transform;
        spec.attribute("talus:geotransform",
                       fmt::format("{} {} {} {} {} {}", t[0], t[1], t[2], t[3], t[4], t[5]));
        if (!document.state.georeference->wkt.empty())
            spec.attribute("talus:crs", document.state.georeference->wkt);
    }
    if (!state.bed_beyond.empty())
        spec.attribute(bed_beyond_attribute,
                       OIIO::TypeDesc(OIIO::TypeDesc::FLOAT, static_cast<int>(state.bed_beyond.size())),
                       state.bed_beyond.data());
    if (document.cut_out) spec.attribute("talus:cut_out", to_text(*document.cut_out));
    const std::vector<float> ground = state.ground();
    std::vector<float> pixels;
    pixels.reserve(ground.size() * names.size());
    for (std::size_t i = 0; i < ground.size(); ++i) {
        pixels.push_back(ground[i]);
        for (const LayerDescription& layer : layers()) {
            const std::span<const float> words = words_of(state, layer);
            if (words.empty()) continue;
            const std::span<const float> texel = words.subspan(i * static_cast<std::size_t>(layer.words()));
            pixels.insert(pixels.end(), texel.begin(),
                          texel.begin() + static_cast<std::ptrdiff_t>(channels_of(layer).size()));
        }
        if (keeps_start) pixels.insert(pixels.end(), {state.start[i].x, state.start[i].y});
    }
    write_encoded(path, spec, pixels.data());
}

}  // namespace talus::io
