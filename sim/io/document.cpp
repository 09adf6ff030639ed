#include "sim/io/document.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "sim/gpu/error.h"
#include "sim/io/picture.h"
#include "sim/passes/paint.h"
#include "sim/passes/water.h"
#include "sim/terrain/gauge.h"

namespace talus {
namespace {

namespace fs = std::filesystem;

// Channels in the order they are written. No dots in their names: Blender takes a file with one for layers of
// a render and shows nothing of it.
const std::vector<std::string> channels = {"Y", "bedrock", "bedrock_low", "regolith", "regolith_low"};
// Behind them where there is water.
const std::vector<std::string> water_channels = {"water", "water_low", "discharge_x", "discharge_y"};
// Where water ever was: the largest depth and when it came; and what brushes painted.
const std::vector<std::string> inundation_channels = {"depth_max", "arrival_s"};
const std::vector<std::string> suspended_channels = {"suspended", "suspended_low"};
const std::vector<std::string> painted_channels = {"hardness", "mask", "rain"};

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

// Throws talus::Error for water that no run could leave and none can go on from.
void check_water(const fs::path& path, const glm::vec4& water) {
    const double speed = glm::length(water_velocity(water.x, {water.z, water.w}));
    // The second word is at most half an ulp of the first.
    if (water.x >= 0 && water.x <= 1e7F && std::abs(water.y) <= 6e-8F * water.x + 1e-44F && speed <= 1e5)
        return;
    throw Error(fmt::format(
        "'{}' holds water of depth {} (and {}) m that runs at {:.3g} m/s: depths must be 0 to 1e7 "
        "m, their second words below their last digit, speeds at most 1e5 m/s",
        path.string(), water.x, water.y, speed));
}

void check_suspended(const fs::path& path, const glm::vec2& load) {
    if (load.x >= 0 && load.x <= 1e6F && std::abs(load.y) <= 6e-8F * load.x + 1e-44F) return;
    throw Error(
        fmt::format("'{}' holds suspended solid of {} (and {}) m: it must be 0 to 1e6, its second word below "
                    "its last digit",
                    path.string(), load.x, load.y));
}

// Throws talus::Error for what no brush could have painted and no run could have noted.
void check_painted(const fs::path& path, const glm::vec4& painted) {
    if (painted.x >= 0 && painted.x <= 1 && painted.y >= 0 && painted.y <= 1 && painted.z >= 0 &&
        painted.z <= most_painted(PaintedLayer::rain))
        return;
    throw Error(
        fmt::format("'{}' holds hardness {}, mask {} and rain {} mm/h in one sample: hardness and mask must "
                    "be 0 to 1, rain 0 to {} mm/h",
                    path.string(), painted.x, painted.y, painted.z, most_painted(PaintedLayer::rain)));
}

void check_inundation(const fs::path& path, const glm::vec2& inundation) {
    if (inundation.x >= 0 && inundation.y >= 0) return;
    throw Error(
        fmt::format("'{}' holds a largest depth of {} m that came after {} s: neither can be less than 0",
                    path.string(), inundation.x, inundation.y));
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
    const std::string transform = spec.get_string_attribute("talus:geotransform");
    if (!transform.empty()) {
        Georeference georeference;
        georeference.wkt = spec.get_string_attribute("talus:crs");
        std::array<double, 6>& t = georeference.transform;
        if (std::sscanf(transform.c_str(), "%lf %lf %lf %lf %lf %lf", &t[0], &t[1], &t[2], &t[3], &t[4],
                        &t[5]) == 6)
            document.state.georeference = georeference;
    }
    std::vector<float> values(state.grid.count());
    const auto read_channel = [&](const std::string& name, auto& layer, int word) {
        const int channel = spec.channelindex(name);
        if (channel < 0) return;
        if (!input->read_image(0, 0, channel, channel + 1, OIIO::TypeDesc::FLOAT, values.data()))
            throw Error(fmt::format("'{}' cannot be read: {}", path.string(), input->geterror()));
        for (std::size_t i = 0; i < values.size(); ++i) {
            if (!std::isfinite(values[i]))
                throw Error(fmt::format("'{}' holds samples in channel '{}' that are not finite numbers",
                                        path.string(), name));
            layer[i][word] = values[i];
        }
    };
    const auto has_any = [&](const std::vector<std::string>& names) {
        return std::any_of(names.begin(), names.end(),
                           [&](const std::string& name) { return spec.channelindex(name) >= 0; });
    };
    state.bedrock.assign(state.grid.count(), glm::vec2(0));
    state.regolith.assign(state.grid.count(), glm::vec2(0));
    read_channel("bedrock", state.bedrock, 0);
    read_channel("bedrock_low", state.bedrock, 1);
    read_channel("regolith", state.regolith, 0);
    read_channel("regolith_low", state.regolith, 1);
    if (spec.channelindex("water") >= 0) {
        state.water.assign(state.grid.count(), glm::vec4(0));
        read_channel("water", state.water, 0);
        read_channel("water_low", state.water, 1);
        // Other programs' names, with dots, and our own.
        for (const char* separator : {".", "_"}) {
            read_channel(std::string("discharge") + separator + "x", state.water, 2);
            read_channel(std::string("discharge") + separator + "y", state.water, 3);
        }
        for (const glm::vec4& water : state.water) check_water(path, water);
    }
    if (has_any(inundation_channels)) {
        state.inundation.assign(state.grid.count(), glm::vec2(0));
        for (int i = 0; i < 2; ++i)
            read_channel(inundation_channels[static_cast<std::size_t>(i)], state.inundation, i);
        for (const glm::vec2& inundation : state.inundation) check_inundation(path, inundation);
    }
    if (has_any(suspended_channels)) {
        state.suspended.assign(state.grid.count(), glm::vec2(0));
        for (int i = 0; i < 2; ++i)
            read_channel(suspended_channels[static_cast<std::size_t>(i)], state.suspended, i);
        for (const glm::vec2& load : state.suspended) check_suspended(path, load);
    }
    if (has_any(painted_channels)) {
        state.painted.assign(state.grid.count(), glm::vec4(0));
        for (int i = 0; i < 3; ++i)
            read_channel(painted_channels[static_cast<std::size_t>(i)], state.painted, i);
        for (const glm::vec4& painted : state.painted) check_painted(path, painted);
    }
    state.springs = springs_from(path, spec.get_string_attribute("talus:springs"));
    for (const Spring& spring : state.springs) check_spring(state.grid, spring);
    return document;
}

}  // namespace

bool is_document(const fs::path& path) {
    if (ending_of(path) != ".exr") return false;
    std::error_code ignored;
    if (!fs::is_regular_file(path, ignored) || fs::file_size(path, ignored) == 0) return false;
    return open_picture(path)->spec().channelindex("bedrock") >= 0;
}

Document open_document(const fs::path& path, const ImportSettings& settings) {
    if (is_document(path)) return read_document(path, settings);
    Heightmap heightmap = read_heightmap(path, settings);
    Document document;
    document.state = bedrock_terrain(heightmap.grid, heightmap.heights);
    document.state.georeference = std::move(heightmap.georeference);
    document.kind = std::move(heightmap.kind);
    document.notes = std::move(heightmap.notes);
    return document;
}

void save_document(const fs::path& path, const Document& document) {
    const TerrainState& state = document.state;
    std::vector<std::string> names = channels;
    const auto add_names = [&](bool there, const std::vector<std::string>& more) {
        if (there) names.insert(names.end(), more.begin(), more.end());
    };
    add_names(!state.water.empty(), water_channels);
    add_names(!state.inundation.empty(), inundation_channels);
    add_names(!state.suspended.empty(), suspended_channels);
    add_names(!state.painted.empty(), painted_channels);
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
    if (!document.parameters.empty()) spec.attribute("talus:parameters", document.parameters);
    if (document.state.georeference) {
        const auto& t = document.state.georeference->transform;
        spec.attribute("talus:geotransform",
                       fmt::format("{} {} {} {} {} {}", t[0], t[1], t[2], t[3], t[4], t[5]));
        if (!document.state.georeference->wkt.empty())
            spec.attribute("talus:crs", document.state.georeference->wkt);
    }
    const std::vector<float> ground = state.ground();
    std::vector<float> pixels;
    pixels.reserve(ground.size() * names.size());
    for (std::size_t i = 0; i < ground.size(); ++i) {
        pixels.insert(pixels.end(), {ground[i], state.bedrock[i].x, state.bedrock[i].y, state.regolith[i].x,
                                     state.regolith[i].y});
        const auto add = [&](const auto& layer, int components) {
            for (int c = 0; c < components && !layer.empty(); ++c) pixels.push_back(layer[i][c]);
        };
        add(state.water, 4);
        add(state.inundation, 2);
        add(state.suspended, 2);
        add(state.painted, 3);
    }
    write_encoded(path, spec, pixels.data());
}

std::vector<float> layer_of(const TerrainState& state, const std::string& name) {
    if (name == "ground") return state.ground();
    if (name == "water" || name == "level") {
        std::vector<float> values =
            name == "level" ? state.ground() : std::vector<float>(state.bedrock.size());
        for (std::size_t i = 0; i < state.water.size(); ++i) values[i] += state.water[i].x;
        return values;
    }
    const auto component = [&](const auto& layer, int c) {
        std::vector<float> values(state.bedrock.size());
        for (std::size_t i = 0; i < layer.size(); ++i) values[i] = layer[i][c];
        return values;
    };
    for (int c = 0; c < 2; ++c)
        if (name == inundation_channels[static_cast<std::size_t>(c)]) return component(state.inundation, c);
    if (name == suspended_channels[0]) return component(state.suspended, 0);
    for (int c = 0; c < 3; ++c)
        if (name == painted_channels[static_cast<std::size_t>(c)]) return component(state.painted, c);
    if (name != "bedrock" && name != "regolith")
        throw Error(
            fmt::format("--layer '{}' is not a layer, it must be one of: ground, bedrock, regolith, "
                        "water, level, depth_max, arrival_s, suspended, hardness, mask, rain",
                        name));
    const std::vector<glm::vec2>& words = name == "bedrock" ? state.bedrock : state.regolith;
    std::vector<float> values(words.size());
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = words[i].x + words[i].y;
    return values;
}

}  // namespace talus
