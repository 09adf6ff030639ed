#include "sim/passes/water_brush.h"

namespace talus {

WaterBrush::WaterBrush(const Terrain& terrain)
    : books("water brush books", static_cast<std::size_t>(terrain.tiles.count()) * sizeof(glm::dvec2)),
      program_("sim/water_brush.comp") {
    books.fill(0);
}

void WaterBrush::dab(Terrain& terrain, const Dab& dab) {
    const std::vector<int> tiles = terrain.tiles.touched_by(dab_region(terrain.grid(), dab));
    if (tiles.empty()) return;
    const DabStep step = dab_step(terrain.grid(), dab);
    const int columns = terrain.tiles.columns();
    const glm::ivec2 first(tiles.front() % columns, tiles.front() / columns);
    const glm::ivec2 last(tiles.back() % columns, tiles.back() / columns);
    terrain.water->front.bind_image(0, gpu::Access::read_write);
    terrain.tiles.bind_for_marking();
    books.bind_storage(1);
    program_.set("samples", glm::ivec2(terrain.grid().nx, terrain.grid().ny));
    program_.set("tiles", glm::ivec2(columns, terrain.tiles.rows()));
    program_.set("first_tile", first);
    program_.set("cell_m", step.cell_m);
    program_.set("dab_sample", step.sample);
    program_.set("dab_offset", step.offset);
    program_.set("dab_radius_m", step.radius_m);
    program_.set("dab_falloff", step.falloff);
    program_.set("dab_amount_m", step.amount_m);
    program_.set("dab_takes", dab.mode == BrushMode::lower ? 1 : 0);
    program_.dispatch(last.x - first.x + 1, last.y - first.y + 1);
}

}  // namespace talus
