#include "sim/passes/inundation.h"

namespace talus {

Inundation::Inundation(const Terrain& terrain)
    : program_("sim/inundation.comp"), changed_(terrain.tiles.count()) {}

void Inundation::record(Terrain& terrain, double simulated_s) {
    terrain.tiles.list(Tiles::water | Tiles::placed, read_, 0, 0, 4, changed_);
    terrain.water->front.bind_image(0, gpu::Access::read);
    terrain.inundation->front.bind_image(1, gpu::Access::read_write);
    terrain.tiles.bind_for_stamping(program_);
    changed_.buffer.bind_storage(1);
    program_.set("samples", glm::ivec2(terrain.grid().nx, terrain.grid().ny));
    program_.set("tiles", glm::ivec2(terrain.tiles.columns(), terrain.tiles.rows()));
    program_.set("arrived_m", static_cast<float>(arrived_m));
    program_.set("now_s", static_cast<float>(simulated_s));
    program_.dispatch_indirect(changed_.buffer);
    gpu::barrier({gpu::Use::image, gpu::Use::sampler, gpu::Use::texture_transfer, gpu::Use::storage,
                  gpu::Use::buffer_transfer});
}

}  // namespace talus
