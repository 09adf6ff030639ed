#include "sim/io/cut_out.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "sim/error.h"
#include "sim/terrain/bed_beyond.h"
#include "sim/terrain/terrain.h"

namespace talus::io {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

// Samples that a place may be off by rounding.
constexpr double rounding = 1e-4;

// Coordinates of a sample's middle.
glm::dvec2 coordinates_of(const std::array<double, 6>& t, glm::dvec2 sample) {
    const glm::dvec2 p = sample + 0.5;
    return {t[0] + t[1] * p.x + t[2] * p.y, t[3] + t[4] * p.x + t[5] * p.y};
}

// Which sample, with fractions, lies at these coordinates.
glm::dvec2 sample_at(const std::array<double, 6>& t, glm::dvec2 coordinates) {
    const double determinant = t[1] * t[5] - t[2] * t[4];
    const glm::dvec2 d = coordinates - glm::dvec2(t[0], t[3]);
    return glm::dvec2(t[5] * d.x - t[2] * d.y, t[1] * d.y - t[4] * d.x) / determinant - 0.5;
}

TileSamples samples_in(const TiledFile& whole, const FileWindow& window) {
    const std::array<double, 6> t = place_of(whole).transform;
    const Grid& grid = whole.grid();
    glm::dvec2 low(1e300);
    glm::dvec2 high(-1e300);
    for (int corner = 0; corner < 4; ++corner) {
        const glm::dvec2 at = sample_at(t, {(corner & 1) != 0 ? window.east : window.west,
                                            (corner & 2) != 0 ? window.north : window.south});
        low = glm::min(low, at);
        high = glm::max(high, at);
    }
    const glm::dvec2 last(grid.nx - 1, grid.ny - 1);
    const bool meets = glm::all(glm::lessThan(low, last)) && glm::all(glm::greaterThan(high, glm::dvec2(0)));
    if (!(window.east > window.west) || !(window.north > window.south) || !meets) {
        const glm::dvec2 a = coordinates_of(t, {0, last.y});
        const glm::dvec2 b = coordinates_of(t, {last.x, 0});
        throw Error(
            fmt::format("--window {},{},{},{} holds nothing of '{}', it must be west, south, east and "
                        "north within {:.10g},{:.10g},{:.10g},{:.10g}",
                        window.west, window.south, window.east, window.north, whole.path().string(),
                        std::min(a.x, b.x), std::min(a.y, b.y), std::max(a.x, b.x), std::max(a.y, b.y)));
    }
    const glm::ivec2 first = glm::clamp(glm::floor(low + rounding), glm::dvec2(0), last);
    const glm::ivec2 end = glm::clamp(glm::ceil(high - rounding), glm::dvec2(0), last);
    return {first, end - first + 1};
}

// The whole's ground beyond the edges of these samples, as far as it goes and is known.
std::vector<float> bed_beyond(const TiledFile& whole, const TileSamples& samples) {
    const glm::ivec2 size(whole.grid().nx, whole.grid().ny);
    const ReadSamples read = whole.source().make_reader();
    // A strip along each edge, without the corners.
    const auto read_strip = [&](glm::ivec2 first, glm::ivec2 end) {
        first = glm::clamp(first, glm::ivec2(0), size);
        end = glm::clamp(end, glm::ivec2(0), size);
        std::vector<float> strip;
        if (glm::all(glm::lessThan(first, end))) read(0, {first, end - first}, strip);
        return [first, end, heights = std::move(strip)](glm::ivec2 at) {
            const bool within =
                glm::all(glm::greaterThanEqual(at, first)) && glm::all(glm::lessThan(at, end));
            const glm::ivec2 p = at - first;
            const float height =
                within ? heights[static_cast<std::size_t>(p.y) * (end.x - first.x) + p.x] : glsl::unknown_bed;
            return std::isnan(height) ? glsl::unknown_bed : height;
        };
    };
    const glm::ivec2 first = samples.first;
    const glm::ivec2 end = first + samples.count;
    constexpr int far = water_ghosts;
    const auto north = read_strip({first.x, first.y - far}, {end.x, first.y});
    const auto south = read_strip({first.x, end.y}, {end.x, end.y + far});
    const auto west = read_strip({first.x - far, first.y}, {first.x, end.y});
    const auto east = read_strip({end.x, first.y}, {end.x + far, end.y});
    return bed_beyond_of({samples.count.x, samples.count.y}, [&](glm::ivec2 at) {
        const glm::ivec2 place = first + at;
        if (at.y < 0) return north(place);
        if (at.y >= samples.count.y) return south(place);
        return at.x < 0 ? west(place) : east(place);
    });
}

}  // namespace

std::string to_text(const CutOut& cut_out) {
    const json text = {{"path", cut_out.path.string()},
                       {"import", json::parse(to_text(cut_out.import))},
                       {"fingerprint", fmt::format("{:016x}", cut_out.fingerprint)}};
    return text.dump(-1, ' ', false, json::error_handler_t::replace);
}

CutOut cut_out_from(const fs::path& document, const std::string& text) {
    try {
        const json parsed = json::parse(text);
        return {parsed.at("path").get<std::string>(), import_settings_from(parsed.at("import").dump()),
                std::stoull(parsed.at("fingerprint").get<std::string>(), nullptr, 16)};
    } catch (const std::exception& error) {
        throw Error(fmt::format("'{}' says that it was cut out of '{}', which cannot be read: {}",
                                document.string(), text, error.what()));
    }
}

CutOutHeights cut_out_heights(const fs::path& path, const ImportSettings& settings) {
    CutOutHeights part;
    part.cut_out.path = path.string().starts_with("/vsi") ? path : fs::absolute(path);
    part.cut_out.import = settings;
    part.cut_out.import.window.reset();
    const TiledFile whole(path, part.cut_out.import);
    part.cut_out.fingerprint = whole.fingerprint();
    const TileSamples samples = samples_in(whole, settings.window.value());
    if (!is_terrain_size(samples.count.x, samples.count.y))
        throw Error(fmt::format("--window holds {} x {} samples of '{}', each side must have {} to {}",
                                samples.count.x, samples.count.y, path.string(), min_samples, max_samples));
    Heightmap& heightmap = part.heightmap;
    heightmap.grid = {samples.count.x, samples.count.y, whole.grid().dx, whole.grid().dy};
    check_grid(heightmap.grid);
    whole.make_reader()(0, samples, heightmap.heights);
    part.bed_beyond = bed_beyond(whole, samples);
    heightmap.georeference = place_of(whole);
    std::array<double, 6>& t = heightmap.georeference->transform;
    t[0] += t[1] * samples.first.x + t[2] * samples.first.y;
    t[3] += t[4] * samples.first.x + t[5] * samples.first.y;
    heightmap.kind = fmt::format("cut out of {}", whole.kind());
    heightmap.notes = whole.notes();
    if (!whole.holds_plain_heights())
        heightmap.notes.push_back(
            fmt::format("work cannot be put back into '{}', whose numbers are not heights as they stand or "
                        "begin in the south or "
                        "east: cut the part out of what 'talus tile' makes of it",
                        path.string()));
    check_finite(path, heightmap);
    return part;
}

Georeference place_of(const TiledFile& whole) {
    if (whole.georeference()) return *whole.georeference();
    const Grid& grid = whole.grid();
    return {"", {-grid.dx / 2, grid.dx, 0, (grid.ny - 0.5) * grid.dy, 0, -grid.dy}};
}

FileWindow window_of(const TiledFile& whole, glm::dvec2 south_west_m, glm::dvec2 north_east_m) {
    const Grid& grid = whole.grid();
    const std::array<double, 6> t = place_of(whole).transform;
    const auto at = [&](glm::dvec2 place_m) {
        return coordinates_of(t, {grid.column_of(place_m.x), grid.row_of(place_m.y)});
    };
    const glm::dvec2 a = at(south_west_m);
    const glm::dvec2 b = at(north_east_m);
    return {std::min(a.x, b.x), std::min(a.y, b.y), std::max(a.x, b.x), std::max(a.y, b.y)};
}

std::optional<glm::ivec2> first_sample_in(const TiledFile& whole, const Grid& grid,
                                          const std::optional<Georeference>& place) {
    if (!place || grid.dx != whole.grid().dx || grid.dy != whole.grid().dy) return std::nullopt;
    const std::array<double, 6> t = place_of(whole).transform;
    const auto sample_in_whole = [&](glm::dvec2 sample) {
        return sample_at(t, coordinates_of(place->transform, sample));
    };
    const glm::dvec2 first = sample_in_whole({0, 0});
    const glm::dvec2 last = sample_in_whole({grid.nx - 1, grid.ny - 1});
    const glm::dvec2 count = last - first + 1.0;
    const auto is_near = [](glm::dvec2 a, glm::dvec2 b) {
        return glm::all(glm::lessThan(glm::abs(a - b), glm::dvec2(0.01)));
    };
    const bool inside = glm::all(glm::greaterThan(first, glm::dvec2(-0.5))) &&
                        glm::all(glm::lessThan(last, glm::dvec2(whole.grid().nx, whole.grid().ny) - 0.5));
    if (!inside || !is_near(first, glm::round(first)) || !is_near(count, {grid.nx, grid.ny}))
        return std::nullopt;
    return glm::ivec2(glm::round(first));
}

}  // namespace talus::io
