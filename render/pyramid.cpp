#include "render/pyramid.h"

#include <algorithm>
#include <cmath>

namespace talus {
namespace {

// Up to level 8, so that a ray over the widest terrain crosses 32 cells at most; small terrains stop at a tile, or
// padding to whole cells of the coarsest level would cost more memory than it saves steps.
int levels_for(const Grid& grid) { return std::min(grid.nx, grid.ny) > 1024 ? 8 : 6; }

gpu::Texture bounds_texture(const char* label, const Grid& grid) {
    const int levels = levels_for(grid);
    const int block = 1 << levels;
    const auto padded = [block](int patches) { return (patches + block - 1) / block * block / 2; };
    return {label, gpu::Format::r32f, padded(grid.nx - 1), padded(grid.ny - 1), levels};
}

const std::vector<std::string> reduce_max = {"REDUCE max", "EMPTY uintBitsToFloat(0xff800000u)"};
const std::vector<std::string> reduce_min = {"REDUCE min", "EMPTY uintBitsToFloat(0x7f800000u)"};

}  // namespace

Pyramid::Pyramid(const Terrain& terrain)
    : highest(bounds_texture("pyramid highest", terrain.grid())),
      lowest(bounds_texture("pyramid lowest", terrain.grid())),
      max_{gpu::Program({"render/pyramid.comp"}, reduce_max), gpu::Program({"render/pyramid_high.comp"}, reduce_max)},
      min_{gpu::Program({"render/pyramid.comp"}, reduce_min), gpu::Program({"render/pyramid_high.comp"}, reduce_min)},
      dirty_(terrain.tiles.count()) {
    highest.fill(-HUGE_VALF);
    lowest.fill(HUGE_VALF);
}

void Pyramid::refresh(Terrain& terrain) {
    // A tile's patches reach one sample into the tiles east and south of it.
    terrain.tiles.take(Tiles::surface, 0, 1, 1, dirty_);
    refresh(max_, highest, terrain);
    refresh(min_, lowest, terrain);
}

void Pyramid::refresh(Half& half, gpu::Texture& bounds, const Terrain& terrain) {
    const glm::ivec2 tiles(terrain.tiles.columns(), terrain.tiles.rows());
    terrain.ground.bind_sampled(0);
    dirty_.buffer.bind_storage(1);
    for (unsigned level = 0; level < 6; ++level) bounds.bind_image(level, gpu::Access::write, static_cast<int>(level));
    half.low_levels.set("patches", glm::ivec2(terrain.grid().nx - 1, terrain.grid().ny - 1));
    half.low_levels.set("tiles", tiles);
    half.low_levels.dispatch_indirect(dirty_.buffer);
    for (int level = 7; level <= top_level(); ++level) {
        bounds.bind_image(0, gpu::Access::read, level - 2);
        bounds.bind_image(1, gpu::Access::write, level - 1);
        half.high_levels.set("tiles", tiles);
        half.high_levels.set("level", level);
        half.high_levels.dispatch_indirect(dirty_.buffer);
    }
}

std::size_t Pyramid::bytes() const {
    std::size_t texels = 0;
    for (int level = 0; level < highest.levels(); ++level)
        texels += static_cast<std::size_t>(highest.width() >> level) * (highest.height() >> level);
    return texels * 2 * sizeof(float);
}

}  // namespace talus
