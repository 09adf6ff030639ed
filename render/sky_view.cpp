#include "render/sky_view.h"

namespace talus::render {

SkyView::SkyView(const Terrain& terrain)
    : program_("render/sky_view.comp"),
      share_("sky share", gpu::Format::r32f, (terrain.grid().nx + 2) / 4, (terrain.grid().ny + 2) / 4),
      dirty_(terrain.tiles.count()) {
    share_.fill(1);
}

void SkyView::refresh(const Terrain& terrain, const Pyramid& pyramid) {
    // A square looks at cells that end less than a tile away.
    terrain.tiles.list(Tiles::ground | Tiles::eroded, read_, -1, 1, 1, dirty_);
    pyramid.bind(program_, terrain);
    program_.bind_image("share", share_);
    program_.bind_storage("TileList", dirty_.buffer);
    program_.set("tiles", glm::ivec2(terrain.tiles.columns(), terrain.tiles.rows()));
    program_.set("squares", glm::ivec2(share_.width(), share_.height()));
    program_.set("patches", glm::ivec2(terrain.grid().nx - 1, terrain.grid().ny - 1));
    program_.set("cell_m", glm::vec2(terrain.grid().dx, terrain.grid().dy));
    program_.dispatch_indirect(dirty_.buffer);
    gpu::barrier({gpu::Use::image, gpu::Use::sampler, gpu::Use::texture_transfer});
}

}  // namespace talus::render
