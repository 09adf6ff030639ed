#include <algorithm>
#include <cmath>

#include "app/core/dialogs.h"
#include "sim/io/heightmap_formats.h"

namespace talus::app {
namespace {

constexpr int preview_side = 320;

// A small picture of heights, lit from the north-west.
std::vector<std::uint8_t> hillshade(const io::Heightmap& heightmap, glm::ivec2 size) {
    const Grid& grid = heightmap.grid;
    const auto [low, high] = std::minmax_element(heightmap.heights.begin(), heightmap.heights.end());
    const double relief = std::max(1e-6, static_cast<double>(*high) - *low);
    const glm::dvec2 step = glm::dvec2(grid.nx - 1, grid.ny - 1) / glm::dvec2(glm::max(size - 1, 1));
    const auto height = [&](int x, int y) {
        const int column = std::clamp(static_cast<int>(std::lround(x * step.x)), 0, grid.nx - 1);
        const int row = std::clamp(static_cast<int>(std::lround(y * step.y)), 0, grid.ny - 1);
        return static_cast<double>(heightmap.heights[static_cast<std::size_t>(row) * grid.nx + column]);
    };
    const glm::dvec3 sun = glm::normalize(glm::dvec3(-1, 1, 1.2));
    std::vector<std::uint8_t> rgba;
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x) {
            const double east = (height(x + 1, y) - height(x - 1, y)) / (2 * step.x * grid.dx);
            const double north = (height(x, y - 1) - height(x, y + 1)) / (2 * step.y * grid.dy);
            const double light = std::max(0.0, glm::dot(glm::normalize(glm::dvec3(-east, -north, 1)), sun));
            const double share = (height(x, y) - *low) / relief;
            for (const double tint : {0.55 + 0.45 * share, 0.60 + 0.35 * share, 0.50 + 0.45 * share})
                rgba.push_back(static_cast<std::uint8_t>(255 * std::clamp(light * 1.15 * tint, 0.0, 1.0)));
            rgba.push_back(255);
        }
    return rgba;
}

}  // namespace

ImportPreview preview_of(const ImportWish& wish) {
    ImportPreview found;
    found.wish = wish;
    try {
        const io::Document document = open_document(wish.path, wish.settings);
        io::Heightmap heightmap;
        heightmap.grid = found.grid = document.state.grid;
        heightmap.heights = document.state.ground();
        const auto [low, high] = std::minmax_element(heightmap.heights.begin(), heightmap.heights.end());
        found.low_m = *low;
        found.high_m = *high;
        found.notes = document.notes;
        found.kind = document.kind;
        if (document.state.georeference) {
            const std::string& wkt = document.state.georeference->wkt;
            const auto quote = wkt.find('"');
            found.crs =
                quote == std::string::npos ? "" : wkt.substr(quote + 1, wkt.find('"', quote + 1) - quote - 1);
        }
        const glm::dvec2 extent(heightmap.grid.width_m(), heightmap.grid.height_m());
        found.picture_size = glm::max(glm::ivec2(extent * (preview_side / std::max(extent.x, extent.y))), 2);
        found.picture = hillshade(heightmap, found.picture_size);
    } catch (const std::exception& failed) {
        found.error = failed.what();
    }
    return found;
}

}  // namespace talus::app
