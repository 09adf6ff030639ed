#include "sim/passes/mask.h"

namespace talus {

void Mask::make(Terrain& terrain, const MaskSettings& settings) {
    const Grid& grid = terrain.grid();
    terrain.add(&Terrain::painted);
    program_.bind_image("painted", terrain.painted->front);
    program_.bind_image("ground", terrain.ground);
    // Where there is no water another image stands in for it, unread.
    program_.bind_image("water", terrain.water ? terrain.water->front : terrain.solid.front);
    terrain.tiles.bind_for_stamping(program_);
    program_.set("samples", glm::ivec2(grid.nx, grid.ny));
    program_.set("tiles", glm::ivec2(terrain.tiles.columns(), terrain.tiles.rows()));
    program_.set("cell_m", glm::vec2(grid.dx, grid.dy));
    program_.set("mask_source", static_cast<int>(settings.source));
    program_.set("mask_low", static_cast<float>(settings.low));
    program_.set("mask_high", static_cast<float>(settings.high));
    program_.set("mask_fade", static_cast<float>(settings.fade));
    program_.set("mask_join", static_cast<int>(settings.join));
    program_.set("mask_inverted", settings.inverted ? 1 : 0);
    program_.set("has_water", terrain.water ? 1 : 0);
    program_.dispatch(terrain.tiles.columns(), terrain.tiles.rows());
    gpu::barrier({gpu::Use::image, gpu::Use::sampler, gpu::Use::storage, gpu::Use::texture_transfer,
                  gpu::Use::buffer_transfer});
}

}  // namespace talus
