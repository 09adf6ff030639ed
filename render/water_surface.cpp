#include "render/water_surface.h"

#include <algorithm>

#include "render/methods/parallel.h"

namespace talus::render {

WaterSurface::WaterSurface(const Terrain& terrain)
    : level_("water level", gpu::Format::r32f, terrain.grid().nx, terrain.grid().ny),
      program_("render/water_surface.comp"),
      // Where water ends, its surface goes by the water of all neighbours.
      pyramid_(
          terrain, level_,
          Tiles::ground | Tiles::eroded | Tiles::water | Tiles::placed | Tiles::painted | Tiles::inundation),
      method_(make_exact(Detail::none)),
      parallel_(make_parallel(Detail::none)) {}

void WaterSurface::refresh(const Terrain& terrain) {
    const TileList& changed = pyramid_.list_changes(terrain);
    program_.bind_image("water_in", terrain.water->front);
    program_.bind_image("ground_in", terrain.ground);
    program_.bind_image("level_out", level_);
    program_.bind_storage("TileList", changed.buffer);
    program_.set("samples", glm::ivec2(terrain.grid().nx, terrain.grid().ny));
    program_.set("tiles", glm::ivec2(terrain.tiles.columns(), terrain.tiles.rows()));
    program_.set("cell_m", glm::vec2(terrain.grid().dx, terrain.grid().dy));
    program_.dispatch_indirect(changed.buffer);
    gpu::barrier({gpu::Use::image, gpu::Use::sampler, gpu::Use::texture_transfer});
    pyramid_.rebuild(terrain);
}

void WaterSurface::cast(const Terrain& terrain, const Camera& camera, int width, int height) {
    if (target_.hits().width() < width || target_.hits().height() < height)
        target_ =
            HitsTarget(std::max(width, target_.hits().width()), std::max(height, target_.hits().height()));
    const Method& method = camera.is_parallel() ? parallel_ : method_;
    method({terrain, pyramid_, camera, width, height, 0, 0, target_.framebuffer()});
}

}  // namespace talus::render
