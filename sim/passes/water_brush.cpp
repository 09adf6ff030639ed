#include "sim/passes/water_brush.h"

namespace talus {

WaterBrush::WaterBrush(const Terrain& terrain)
    : book_("water brush books", static_cast<std::size_t>(terrain.tiles.count()) * sizeof(glm::dvec2)),
      program_("sim/water_brush.comp") {
    book_.fill(0);
}

Book WaterBrush::book() {
    return {"water brush", &book_,
            [](const gpu::Buffer& words, const Grid& grid, const SolidWeights&, BudgetTerms& terms) {
                const double area_m2 = grid.dx * grid.dy;
                for (const glm::dvec2& tile : words.read_all<glm::dvec2>()) {
                    terms.water.brush_in_m3 += tile.x * area_m2;
                    terms.water.brush_out_m3 += tile.y * area_m2;
                }
            }};
}

void WaterBrush::dab(Terrain& terrain, const Dab& dab) {
    const std::vector<int> tiles = terrain.tiles.touched_by(dab_region(terrain.grid(), dab));
    if (tiles.empty()) return;
    program_.bind_image("water", terrain.water->front);
    terrain.tiles.bind_for_stamping(program_);
    program_.bind_storage("TileBooks", book_);
    numbers_.set(dab_numbers(terrain.grid(), dab));
    set_dab(program_, terrain, numbers_);
    const TileBlock block = tile_block(terrain.tiles, tiles);
    program_.set("first_tile", block.first);
    program_.dispatch(block.size.x, block.size.y);
    gpu::barrier({gpu::Use::image, gpu::Use::sampler, gpu::Use::storage, gpu::Use::texture_transfer,
                  gpu::Use::buffer_transfer});
}

}  // namespace talus
