#include "render/pyramid.h"

#include <algorithm>
#include <cmath>

namespace talus::render {
namespace {

int padded(int patches, int levels) {
    const int block = 1 << levels;
    return (patches + block - 1) / block * block;
}

// Up to level 8, so that a ray over the widest terrain crosses 32 cells at most; fewer where padding to whole
// cells of the coarsest level would take more than 4 bytes a sample for both bounds (3 are taken without
// padding).
int levels_for(const Grid& grid) {
    for (int levels = 8; levels > 1; --levels) {
        const double texels = static_cast<double>(padded(grid.nx - 1, levels)) * padded(grid.ny - 1, levels);
        if (3 * texels <= 4 * static_cast<double>(grid.count())) return levels;
    }
    return 1;
}

glm::ivec2 level_1_for(const Grid& grid) {
    return glm::ivec2(padded(grid.nx - 1, levels_for(grid)), padded(grid.ny - 1, levels_for(grid))) / 2;
}

gpu::Texture bounds_texture(const char* label, glm::ivec2 level_1) {
    return {label, gpu::Format::r32f, level_1.x, level_1.y + std::max(level_1.y / 2, 1)};
}

}  // namespace

// Paint changes no height, but the picture over it must be redrawn.
Pyramid::Pyramid(const Terrain& terrain)
    : Pyramid(terrain, nullptr, Tiles::ground | Tiles::eroded | Tiles::painted) {}

Pyramid::Pyramid(const Terrain& terrain, const gpu::Texture& surface, std::uint32_t changes)
    : Pyramid(terrain, &surface, changes) {}

Pyramid::Pyramid(const Terrain& terrain, const gpu::Texture* surface, std::uint32_t changes)
    : highest(bounds_texture("pyramid highest", level_1_for(terrain.grid()))),
      lowest(bounds_texture("pyramid lowest", level_1_for(terrain.grid()))),
      surface_(surface),
      changes_(changes),
      top_level_(levels_for(terrain.grid())),
      level_1_size_(level_1_for(terrain.grid())),
      low_levels_("render/pyramid.comp"),
      high_levels_("render/pyramid_high.comp"),
      dirty_(terrain.tiles.count()) {
    highest.fill(-HUGE_VALF);
    lowest.fill(HUGE_VALF);
}

const TileList& Pyramid::list_changes(const Terrain& terrain) {
    // A tile's patches reach one sample into the tiles east and south of it.
    terrain.tiles.list(changes_, read_, surface_ ? -1 : 0, 1, 1, dirty_);
    return dirty_;
}

void Pyramid::rebuild(const Terrain& terrain) {
    const auto prepare = [&](gpu::Program& program) {
        program.bind_sampled("ground", surface_of(terrain));
        program.bind_storage("TileList", dirty_.buffer);
        program.bind_image("highest", highest);
        program.bind_image("lowest", lowest);
        program.set("level_1_size", level_1_size_);
        program.set("top_level", top_level_);
        program.set("tiles", glm::ivec2(terrain.tiles.columns(), terrain.tiles.rows()));
    };
    prepare(low_levels_);
    low_levels_.set("patches", glm::ivec2(terrain.grid().nx - 1, terrain.grid().ny - 1));
    low_levels_.dispatch_indirect(dirty_.buffer);
    gpu::barrier({gpu::Use::image, gpu::Use::sampler, gpu::Use::texture_transfer});
    prepare(high_levels_);
    high_levels_.dispatch(1);
    gpu::barrier({gpu::Use::image, gpu::Use::sampler, gpu::Use::texture_transfer});
}

void Pyramid::bind(gpu::Program& program, const Terrain& terrain) const {
    program.bind_sampled("ground", surface_of(terrain));
    program.bind_sampled("tops", highest);
    program.bind_sampled("bottoms", lowest);
    program.set("top_level", top_level_);
    program.set("level_1_size", level_1_size_);
}

}  // namespace talus::render
