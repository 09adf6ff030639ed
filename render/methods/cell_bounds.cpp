#include "render/methods/cell_bounds.h"

#include <algorithm>

namespace talus::render {
namespace {

// As many as keep any device busy; each takes every so many-th of the listed cells.
constexpr int most_groups = 256;

}  // namespace

void CellBounds::make_room(const Terrain& terrain, int cell_patches) {
    const Grid& grid = terrain.grid();
    const glm::ivec2 count((grid.nx - 2 + cell_patches) / cell_patches,
                           (grid.ny - 2 + cell_patches) / cell_patches);
    const glm::ivec2 samples(grid.nx, grid.ny);
    if (cell_patches == cell_patches_ && samples == samples_) return;
    samples_ = samples;
    const std::size_t cells = static_cast<std::size_t>(count.x) * count.y;
    cell_patches_ = cell_patches;
    bounds_ = gpu::Texture("cell bounds", gpu::Format::rg32f, count.x, count.y);
    listed_ = gpu::Buffer("changed cells", (1 + cells) * sizeof(std::uint32_t));
    marks_ = gpu::Buffer("marks of changed cells", cells * sizeof(std::uint32_t));
    marks_.fill(0);
    changed_ = std::make_unique<TileList>(terrain.tiles.count());
    read_ = {};
}

void CellBounds::refresh(const Terrain& terrain, int cell_patches) {
    make_room(terrain, cell_patches);
    const std::uint32_t none = 0;
    listed_.write(0, std::as_bytes(std::span(&none, 1)));
    if (read_ == terrain.tiles.reader_now()) return;
    terrain.tiles.list(Tiles::ground | Tiles::eroded, read_, 0, 0, 1, *changed_);
    const glm::ivec2 patches(terrain.grid().nx - 1, terrain.grid().ny - 1);
    const auto prepare = [&](gpu::Program& program) {
        program.bind_storage("CellList", listed_);
        program.bind_storage("CellMarks", marks_);
        program.set("patches", patches);
        program.set("cell_patches", cell_patches_);
        program.set("cell_count", count());
    };
    prepare(changes_);
    changes_.bind_storage("TileList", changed_->buffer);
    changes_.set("tiles", glm::ivec2(terrain.tiles.columns(), terrain.tiles.rows()));
    changes_.dispatch_indirect(changed_->buffer);
    gpu::barrier({gpu::Use::storage});
    prepare(program_);
    program_.bind_sampled("ground", terrain.ground);
    program_.bind_image("cell_bounds", bounds_);
    program_.dispatch(std::min(count().x * count().y, most_groups));
    gpu::barrier({gpu::Use::storage, gpu::Use::image, gpu::Use::sampler, gpu::Use::buffer_transfer});
}

void CellBounds::bind(gpu::Program& program) const {
    program.bind_sampled("cell_bounds", bounds_);
    program.set("cell_patches", cell_patches_);
    program.set("cell_count", count());
}

int CellBounds::refreshed() const {
    std::uint32_t listed = 0;
    listed_.read(0, std::as_writable_bytes(std::span(&listed, 1)));
    return static_cast<int>(listed);
}

std::size_t CellBounds::bytes() const {
    return 2 * sizeof(float) * count().x * count().y + listed_.bytes() + marks_.bytes();
}

}  // namespace talus::render
