#include "sim/passes/paint.h"

#include "sim/terrain/layers.h"

namespace talus {

void Paint::dab(Terrain& terrain, const Dab& dab) {
    const PaintedNumberDescription& number = description_of(painted_number(dab.material));
    terrain.ever_painted[static_cast<std::size_t>(painted_number(dab.material))] = true;
    const std::vector<int> reached = terrain.tiles.touched_by(dab_region(terrain.grid(), dab));
    if (reached.empty()) return;
    terrain.add(number.layer().image);
    gpu::Program& program = number.has_share ? land_cover_program_ : program_;
    if (number.has_share) program.bind_image("land_cover", terrain.land_cover->front);
    terrain.tiles.bind_for_stamping(program);
    numbers_.set(dab_numbers(terrain.grid(), dab));
    set_dab(program, terrain, numbers_);
    program.set("painted_word", number.word());
    const TileBlock block = tile_block(terrain.tiles, reached);
    program.set("first_tile", block.first);
    program.dispatch(block.size.x, block.size.y);
    gpu::barrier({gpu::Use::image, gpu::Use::sampler, gpu::Use::storage, gpu::Use::texture_transfer,
                  gpu::Use::buffer_transfer});
}

}  // namespace talus
