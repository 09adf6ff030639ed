#include "sim/passes/paint.h"

namespace talus {

void Paint::dab(Terrain& terrain, const Dab& dab) {
    if (dab.material == Material::rain) terrain.rain_painted = true;
    const std::vector<int> reached = terrain.tiles.touched_by(dab_region(terrain.grid(), dab));
    if (reached.empty()) return;
    terrain.add(&Terrain::painted);
    program_.bind_image("painted", terrain.painted->front);
    terrain.tiles.bind_for_stamping(program_);
    numbers_.set(dab_numbers(terrain.grid(), dab));
    set_dab(program_, terrain, numbers_);
    program_.set("painted_layer", static_cast<int>(painted_layer(dab.material)));
    const TileBlock block = tile_block(terrain.tiles, reached);
    program_.set("first_tile", block.first);
    program_.dispatch(block.size.x, block.size.y);
    gpu::barrier({gpu::Use::image, gpu::Use::sampler, gpu::Use::storage, gpu::Use::texture_transfer,
                  gpu::Use::buffer_transfer});
}

}  // namespace talus
