#include "app/core/ground_samples.h"

namespace talus::app {
namespace {

// Where a place is among a grid's samples; none beside them.
std::optional<glm::dvec2> place_on(const Grid& grid, glm::dvec2 place_m) {
    // Who stands on the outermost samples is not beside the terrain by rounding.
    constexpr double rounding = 1e-9;
    const glm::dvec2 asked(grid.column_of(place_m.x), grid.row_of(place_m.y));
    const glm::dvec2 place = glm::clamp(asked, glm::dvec2(0), glm::dvec2(grid.nx - 1, grid.ny - 1));
    if (glm::any(glm::greaterThan(glm::abs(asked - place), glm::dvec2(rounding)))) return std::nullopt;
    return place;
}

}  // namespace

std::optional<GroundSamples> ground_samples_of(const Terrain& terrain, glm::dvec2 place_m) {
    const Grid& grid = terrain.grid();
    const auto place = place_on(grid, place_m);
    if (!place) return std::nullopt;
    return GroundSamples{&terrain.ground, {0, 0}, {grid.nx, grid.ny}, *place, 0, terrain.tiles.now()};
}

std::optional<GroundSamples> ground_samples_of(const render::TiledSurface& surface, glm::dvec2 place_m) {
    const TileTree& tree = surface.tree();
    const auto place = place_on(tree.grid(), place_m);
    const auto held = place ? surface.finest_at(*place) : std::nullopt;
    if (!held) return std::nullopt;
    const TileSamples samples = tree.samples_of(held->tile);
    return GroundSamples{held->heights,
                         held->corner,
                         samples.count,
                         tree.place_in(held->tile.level, *place) - glm::dvec2(samples.first),
                         tree.index_of(held->tile) + 1,
                         0};
}

}  // namespace talus::app
