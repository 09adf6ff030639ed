#include "render/methods/height_levels.h"

#include <algorithm>

namespace talus::render {

glm::ivec2 HeightLevels::size(int level) const {
    return ((patches_ + (1 << level) - 1) >> level) + 1;
}

// Level 1 on top, the coarser ones side by side below it.
glm::ivec2 HeightLevels::offset(int level) const {
    if (level < 2) return {0, 0};
    glm::ivec2 at(0, size(1).y);
    for (int finer = 2; finer < level; ++finer) at.x += size(finer).x;
    return at;
}

void HeightLevels::refresh(const Terrain& terrain, int levels, const TileList& changed) {
    const glm::ivec2 patches(terrain.grid().nx - 1, terrain.grid().ny - 1);
    if (patches != patches_ || levels != levels_) {
        patches_ = patches;
        levels_ = levels;
        const int width = std::max(size(1).x, offset(levels).x);
        image_ = gpu::Texture("levels of heights", gpu::Format::r32f, width,
                              size(1).y + (levels > 2 ? size(2).y : 0));
    }
    for (int level = 1; level < levels; ++level) {
        program_.bind_storage("TileList", changed.buffer);
        program_.bind_sampled("ground", terrain.ground);
        program_.bind_image("height_levels", image_);
        program_.set("tiles", glm::ivec2(terrain.tiles.columns(), terrain.tiles.rows()));
        program_.set("patches", patches_);
        program_.set("level", level);
        program_.set("offset", offset(level));
        program_.set("finer_offset", offset(level - 1));
        program_.dispatch_indirect(changed.buffer);
        gpu::barrier({gpu::Use::image, gpu::Use::sampler});
    }
}

void HeightLevels::bind(gpu::Program& program, int level) const {
    program.bind_sampled("height_levels", image_);
    program.set("patches", patches_);
    program.set("offset", offset(level));
    program.set("coarser_offset", offset(level + 1));
}

}  // namespace talus::render
