#include "sim/io/map_export.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numeric>
#include <set>

#include "sim/error.h"
#include "sim/io/atomic_file.h"
#include "sim/io/endings.h"
#include "sim/io/heightmap_formats.h"
#include "sim/io/picture.h"
#include "sim/terrain/layers.h"
#include "sim/terrain/reshape.h"

namespace talus::io {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

// Whether any layer is there that the map is made of.
bool is_there(const TerrainState& state, const std::string& map) {
    const std::vector<std::string> numbers = numbers_of_output(map);
    return numbers.empty() || std::any_of(numbers.begin(), numbers.end(), [&](const std::string& number) {
               return !words_of(state, *number_named(number)->layer).empty();
           });
}

// Where the samples of no other map are.
constexpr const char* rest_name = "rest";

constexpr const char* absent = "0 throughout: the terrain has no such layer";

void check_maps(const ExportSettings& settings) {
    if (settings.maps.empty()) throw Error("no maps are named: give one or more of --maps, or tick them");
    const std::vector<std::string> names = output_names();
    std::set<std::string> seen;
    for (const std::string& map : settings.maps) {
        if (std::find(names.begin(), names.end(), map) == names.end())
            throw Error(fmt::format("'{}' is not a map, it must be one of: {}", map, fmt::join(names, ", ")));
        if (!seen.insert(map).second) throw Error(fmt::format("the map '{}' is named twice", map));
    }
    if (settings.weight_bits != 0 && settings.weight_bits != 8 && settings.weight_bits != 16)
        throw Error(
            fmt::format("weights of {} bits cannot be written, it must be 8 or 16", settings.weight_bits));
    const std::vector<std::string> endings =
        settings.weight_bits == 0 ? writable_endings() : std::vector<std::string>{".png"};
    if (std::find(endings.begin(), endings.end(), ending_of(settings.path)) == endings.end())
        throw Error(fmt::format("cannot write maps as '{}': its ending must be one of {}",
                                settings.path.string(), fmt::join(endings, ", ")));
}

fs::path path_of(const ExportSettings& settings, const std::string& map) {
    fs::path named = settings.path;
    return named.replace_filename(
        fmt::format("{}_{}{}", settings.path.stem().string(), map, settings.path.extension().string()));
}

void write_grey(const fs::path& path, const Grid& grid, const std::vector<std::uint16_t>& values, int bits) {
    if (bits == 16)
        return write_encoded(path, OIIO::ImageSpec(grid.nx, grid.ny, 1, OIIO::TypeDesc::UINT16),
                             values.data());
    std::vector<std::uint8_t> bytes(values.begin(), values.end());
    write_encoded(path, OIIO::ImageSpec(grid.nx, grid.ny, 1, OIIO::TypeDesc::UINT8), bytes.data());
}

// Gives the values at the ends of its scale.
Range write_values(const TerrainState& state, const fs::path& of_all, const fs::path& path,
                   const std::string& map, json& said) {
    Heightmap heightmap;
    heightmap.grid = state.grid;
    heightmap.heights = output_of(state, map);
    heightmap.georeference = state.georeference;
    const Range range = range_for(heightmap, std::nullopt);
    write_heightmap(path, heightmap, range);
    said["unit"] = output_unit(map);
    said["low"] = range.x;
    said["high"] = range.y;
    const HeightmapFormat* format = format_of(of_all);
    if (format && format->rounds) said["step"] = (range.y - range.x) / 65535;
    return range;
}

}  // namespace

std::vector<float> shares_of(const std::string& map, const std::vector<float>& values) {
    const auto share = [&](auto&& of) {
        std::vector<float> shares(values.size());
        std::transform(values.begin(), values.end(), shares.begin(), [&](float value) {
            return static_cast<float>(std::clamp(static_cast<double>(of(value)), 0.0, 1.0));
        });
        return shares;
    };
    if (map == "hardness" || map == "mask") return share([](float value) { return value; });
    if (map == "slope") return share([](float value) { return value / 60; });
    if (map == "flow") {
        const double largest = *std::max_element(values.begin(), values.end());
        return share([&](float value) { return value > 0 ? 1 + std::log10(value / largest) / 4 : 0; });
    }
    std::vector<float> sorted = values;
    const auto upper = sorted.begin() + static_cast<std::ptrdiff_t>((sorted.size() - 1) * 199 / 200);
    std::nth_element(sorted.begin(), upper, sorted.end());
    const double high = *upper;
    // What is nowhere negative counts from 0.
    const double low = std::min(0.0F, *std::min_element(values.begin(), values.end()));
    // Where less than a two-hundredth of the samples has any, the largest is 1.
    const double largest = *std::max_element(values.begin(), values.end());
    const double end = high > low ? high : largest;
    return share([&](float value) { return end > low ? (value - low) / (end - low) : 0; });
}

std::vector<std::vector<std::uint16_t>> weights_of(const std::vector<std::vector<float>>& shares, int sum) {
    const std::size_t planes = shares.size() + 1;
    const std::size_t samples = shares.front().size();
    std::vector<std::vector<std::uint16_t>> weights(planes, std::vector<std::uint16_t>(samples));
    std::vector<double> wanted(planes);
    std::vector<std::size_t> order(planes);
    for (std::size_t i = 0; i < samples; ++i) {
        double all = 0;
        for (std::size_t k = 0; k + 1 < planes; ++k) all += wanted[k] = shares[k][i];
        for (std::size_t k = 0; k + 1 < planes; ++k) wanted[k] *= sum / std::max(all, 1.0);
        wanted.back() = sum * std::max(0.0, 1 - all);
        int left = sum;
        for (std::size_t k = 0; k < planes; ++k) {
            weights[k][i] =
                static_cast<std::uint16_t>(std::min(std::floor(wanted[k]), static_cast<double>(left)));
            left -= weights[k][i];
        }
        std::iota(order.begin(), order.end(), std::size_t{0});
        std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
            return wanted[a] - std::floor(wanted[a]) > wanted[b] - std::floor(wanted[b]);
        });
        for (std::size_t k = 0; left > 0; k = (k + 1) % planes, --left) ++weights[order[k]][i];
    }
    return weights;
}

Exported export_maps(const TerrainState& state, const ExportSettings& settings) {
    check_maps(settings);
    const bool as_it_is = settings.samples_for == ExportKind::heightmap;
    TerrainState for_it;
    if (!as_it_is) {
        const glm::ivec2 samples = samples_for_engine(state.grid, settings.samples_for);
        for_it = resampled(state, samples.x, samples.y);
    }
    const TerrainState& written = as_it_is ? state : for_it;
    const Grid& grid = written.grid;
    Exported exported;
    exported.tile_samples = {grid.nx, grid.ny};
    exported.spacing_m = {grid.dx, grid.dy};
    json all = json::array();
    const auto add = [&](const std::string& map) -> json& {
        exported.files.push_back(path_of(settings, map));
        all.push_back({{"map", map}, {"file", exported.files.back().filename().string()}});
        return all.back();
    };
    if (settings.weight_bits == 0) {
        for (const std::string& map : settings.maps) {
            json& said = add(map);
            const Range range = write_values(written, settings.path, exported.files.back(), map, said);
            exported.values.emplace_back(
                map, is_there(written, map)
                         ? fmt::format("{:.6g} to {:.6g} {}", range.x, range.y, output_unit(map))
                         : absent);
        }
    } else {
        const int sum = (1 << settings.weight_bits) - 1;
        std::vector<std::vector<float>> shares;
        shares.reserve(settings.maps.size());
        for (const std::string& map : settings.maps)
            shares.push_back(shares_of(map, output_of(written, map)));
        const std::vector<std::vector<std::uint16_t>> weights = weights_of(shares, sum);
        for (std::size_t k = 0; k < weights.size(); ++k) {
            const std::string map = k < settings.maps.size() ? settings.maps[k] : rest_name;
            add(map)["weights_sum_to"] = sum;
            write_grey(exported.files.back(), grid, weights[k], settings.weight_bits);
            const double mean =
                std::accumulate(weights[k].begin(), weights[k].end(), 0.0) / grid.count() / sum;
            const bool there = k == settings.maps.size() || is_there(written, map);
            exported.values.emplace_back(map, there ? fmt::format("{:.3g} on average", mean) : absent);
        }
    }
    fs::path said = settings.path;
    said.replace_extension(".json");
    const json ranges = {
        {"columns", grid.nx}, {"rows", grid.ny}, {"spacing_m", {grid.dx, grid.dy}}, {"maps", all}};
    write_atomically(said, ranges.dump(2) + "\n");
    exported.files.push_back(said);
    return exported;
}

}  // namespace talus::io
