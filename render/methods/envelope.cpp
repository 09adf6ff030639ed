#include "render/methods/envelope.h"

namespace talus::render {

void Envelope::refresh(const Terrain& terrain) {
    const Grid& grid = terrain.grid();
    if (heights_.width() != grid.nx || heights_.height() != grid.ny) {
        heights_ = gpu::Texture("envelope", gpu::Format::r32f, grid.nx, grid.ny);
        versions_ = gpu::Buffer("versions of envelope tiles", sizeof(float) * terrain.tiles.count());
        versions_.fill(0);
        changed_ = std::make_unique<TileList>(terrain.tiles.count());
        read_ = {};
    }
    if (read_ == terrain.tiles.reader_now()) return;
    // A sample is raised by its neighbours in the tiles east and south of its own.
    terrain.tiles.list(Tiles::ground | Tiles::eroded, read_, 0, 1, 1, *changed_);
    program_.bind_storage("TileList", changed_->buffer);
    program_.bind_storage("EnvelopeVersions", versions_);
    program_.bind_sampled("ground", terrain.ground);
    program_.bind_image("envelope", heights_);
    program_.set("tiles", glm::ivec2(terrain.tiles.columns(), terrain.tiles.rows()));
    program_.set("patches", glm::ivec2(grid.nx - 1, grid.ny - 1));
    program_.dispatch_indirect(changed_->buffer);
    gpu::barrier({gpu::Use::image, gpu::Use::sampler, gpu::Use::storage, gpu::Use::texture_transfer,
                  gpu::Use::buffer_transfer});
}

}  // namespace talus::render
