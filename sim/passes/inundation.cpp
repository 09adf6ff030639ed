#include "sim/passes/inundation.h"

namespace talus {

Inundation::Inundation(const Terrain& terrain)
    : program_("sim/inundation.comp"), changed_(terrain.tiles.count()) {}

void Inundation::record(Terrain& terrain, double simulated_s) {
    terrain.tiles.list(Tiles::water | Tiles::placed, read_, 0, 0, glsl::tile_strips, changed_);
    program_.bind_image("water", terrain.water->front);
    program_.bind_image("inundation", terrain.inundation->front);
    terrain.tiles.bind_for_stamping(program_);
    program_.bind_storage("TileList", changed_.buffer);
    program_.set("samples", glm::ivec2(terrain.grid().nx, terrain.grid().ny));
    program_.set("tiles", glm::ivec2(terrain.tiles.columns(), terrain.tiles.rows()));
    program_.set("now_s", static_cast<float>(simulated_s));
    program_.dispatch_indirect(changed_.buffer);
    gpu::barrier({gpu::Use::image, gpu::Use::sampler, gpu::Use::texture_transfer, gpu::Use::storage,
                  gpu::Use::buffer_transfer});
}

}  // namespace talus
