#include "sim/io/heightmap.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <cmath>

#include "sim/error.h"
#include "sim/io/heightmap_formats.h"

namespace talus::io {

namespace fs = std::filesystem;

const char* const range_unused =
    "the heights are metres already, so --range did not change how they were read";

void check_file_size(const fs::path& path, std::int64_t nx, std::int64_t ny) {
    const bool too_small = std::min(nx, ny) < min_samples;
    const bool too_large = std::max(nx, ny) > max_samples;
    const char* const larger =
        too_large && !too_small ? "; 'talus tile' and 'talus render' take larger rasters" : "";
    if (too_small || too_large)
        throw Error(fmt::format("'{}' holds {} x {} samples, each side must have {} to {}{}", path.string(),
                                nx, ny, min_samples, max_samples, larger));
    check_grid({static_cast<int>(nx), static_cast<int>(ny), 1, 1});
}

void check_finite(const fs::path& path, const Heightmap& heightmap) {
    const auto bad = std::count_if(heightmap.heights.begin(), heightmap.heights.end(),
                                   [](float h) { return !std::isfinite(h); });
    if (bad > 0)
        throw Error(fmt::format(
            "'{}' holds {} samples that are not finite numbers, declare them as nodata or mend them",
            path.string(), bad));
}

void scale_integers(Heightmap& heightmap, double largest, std::optional<Range> own,
                    const ImportSettings& settings) {
    Range range(0, std::max(heightmap.grid.width_m(), heightmap.grid.height_m()) / 8);
    if (settings.range_m)
        range = *settings.range_m;
    else if (own)
        range = *own;
    else
        heightmap.notes.push_back(fmt::format(
            "heights guessed as 0 to {:.6g} m, an eighth of the longer side: --range lo,hi sets them",
            range.y));
    for (float& h : heightmap.heights) h = static_cast<float>(range.x + h / largest * (range.y - range.x));
}

void scale_floats(Heightmap& heightmap, const ImportSettings& settings) {
    const auto [low, high] = std::minmax_element(heightmap.heights.begin(), heightmap.heights.end());
    if (!(*low >= 0 && *high <= 1 && *high > *low)) {
        if (settings.range_m) heightmap.notes.push_back(range_unused);
        return;
    }
    if (settings.range_m) {
        const Range range = *settings.range_m;
        for (float& h : heightmap.heights) h = static_cast<float>(range.x + h * (range.y - range.x));
    } else {
        heightmap.notes.push_back(
            "all heights lie within 0 to 1 m: --range lo,hi spreads 0 to 1 over lo to hi metres");
    }
}

Range range_for(const Heightmap& heightmap, std::optional<Range> range) {
    if (range) return *range;
    const auto [low, high] = std::minmax_element(heightmap.heights.begin(), heightmap.heights.end());
    return {*low, *high > *low ? *high : *low + 1};
}

std::vector<std::uint16_t> quantise(const Heightmap& heightmap, Range range) {
    std::vector<std::uint16_t> values(heightmap.heights.size());
    std::transform(heightmap.heights.begin(), heightmap.heights.end(), values.begin(), [&](float h) {
        const double share = (h - range.x) / (range.y - range.x);
        return static_cast<std::uint16_t>(std::lround(std::clamp(share, 0.0, 1.0) * 65535));
    });
    return values;
}

Heightmap read_heightmap(const fs::path& path, const ImportSettings& settings) {
    std::error_code ignored;
    if (!fs::exists(path, ignored))
        throw Error(fmt::format("'{}' does not exist, give the path of a heightmap", path.string()));
    if (fs::is_directory(path, ignored))
        throw Error(fmt::format("'{}' is a folder, give the path of a heightmap", path.string()));
    if (fs::file_size(path, ignored) == 0)
        throw Error(fmt::format("'{}' is empty, a heightmap was expected", path.string()));
    const HeightmapFormat* format = format_of(path);
    if (!format)
        throw Error(
            fmt::format("'{}' ends in none of {}", path.string(), fmt::join(readable_endings(), ", ")));
    Heightmap heightmap = format->read(path, settings);
    if (settings.spacing_m) heightmap.grid.dx = heightmap.grid.dy = *settings.spacing_m;
    check_finite(path, heightmap);
    check_grid(heightmap.grid);
    return heightmap;
}

void write_heightmap(const fs::path& path, const Heightmap& heightmap, std::optional<Range> range) {
    if (!can_write_heightmap(path))
        throw Error(fmt::format("cannot write '{}': its ending must be one of {}", path.string(),
                                fmt::join(writable_endings(), ", ")));
    format_of(path)->write(path, heightmap, range);
}

}  // namespace talus::io
