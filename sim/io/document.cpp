#include "sim/io/document.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "sim/gpu/error.h"
#include "sim/io/picture.h"
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

bool is_document(const fs::path& path) {
    if (ending_of(path) != ".exr") return false;
    std::error_code ignored;
    if (!fs::is_regular_file(path, ignored) || fs::file_size(path, ignored) == 0) return false;
    return open_picture(path)->spec().channelindex("bedrock") >= 0;
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
            document.georeference = georeference;
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
    state.springs = springs_from(path, spec.get_string_attribute("talus:springs"));
    for (const Spring& spring : state.springs) check_spring(state.grid, spring);
    return document;
}

}  // namespace

Document open_document(const fs::path& path, const ImportSettings& settings) {
    if (is_document(path)) return read_document(path, settings);
    Heightmap heightmap = read_heightmap(path, settings);
    Document document;
    document.state = bedrock_terrain(heightmap.grid, heightmap.heights);
    document.georeference = std::move(heightmap.georeference);
    document.kind = std::move(heightmap.kind);
    document.notes = std::move(heightmap.notes);
    return document;
}

void save_document(const fs::path& path, const Document& document) {
    const TerrainState& state = document.state;
    std::vector<std::string> names = channels;
    if (!state.water.empty()) names.insert(names.end(), water_channels.begin(), water_channels.end());
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
    if (document.georeference) {
        const auto& t = document.georeference->transform;
        spec.attribute("talus:geotransform",
                       fmt::format("{} {} {} {} {} {}", t[0], t[1], t[2], t[3], t[4], t[5]));
        if (!document.georeference->wkt.empty()) spec.attribute("talus:crs", document.georeference->wkt);
    }
    const std::vector<float> ground = state.ground();
    std::vector<float> pixels;
    pixels.reserve(ground.size() * names.size());
    for (std::size_t i = 0; i < ground.size(); ++i) {
        pixels.insert(pixels.end(), {ground[i], state.bedrock[i].x, state.bedrock[i].y, state.regolith[i].x,
                                     state.regolith[i].y});
        if (state.water.empty()) continue;
        const glm::vec4& water = state.water[i];
        pixels.insert(pixels.end(), {water.x, water.y, water.z, water.w});
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
    if (name != "bedrock" && name != "regolith")
        throw Error(fmt::format(
            "--layer '{}' is not a layer, it must be one of: ground, bedrock, regolith, water, level", name));
    const std::vector<glm::vec2>& words = name == "bedrock" ? state.bedrock : state.regolith;
    std::vector<float> values(words.size());
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = words[i].x + words[i].y;
    return values;
}

}  // namespace talus
