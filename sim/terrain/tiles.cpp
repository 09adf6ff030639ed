#include "sim/terrain/tiles.h"

#include <algorithm>
#include <array>

namespace talus {

TileList::TileList(int tile_count)
    : buffer("tile list", (4 + static_cast<std::size_t>(tile_count)) * sizeof(std::uint32_t)) {
    buffer.fill(0);
}

Tiles::Tiles(const Grid& grid)
    : grid_(grid),
      columns_((grid.nx + tile_samples - 1) / tile_samples),
      rows_((grid.ny + tile_samples - 1) / tile_samples),
      flags_("tile flags", static_cast<std::size_t>(columns_) * rows_ * sizeof(std::uint32_t)),
      list_program_("sim/tile_list.comp"),
      clear_program_("sim/tile_clear.comp") {
    mark_all();
}

gpu::Region Tiles::region(int tile) const {
    const int x = tile % columns_ * tile_samples;
    const int y = tile / columns_ * tile_samples;
    return {x, y, std::min(tile_samples, grid_.nx - x), std::min(tile_samples, grid_.ny - y)};
}

std::vector<int> Tiles::touched_by(const gpu::Region& samples) const {
    std::vector<int> tiles;
    const int x0 = std::max(samples.x, 0) / tile_samples;
    const int y0 = std::max(samples.y, 0) / tile_samples;
    const int x1 = std::min(samples.x + samples.width, grid_.nx);
    const int y1 = std::min(samples.y + samples.height, grid_.ny);
    for (int y = y0; y * tile_samples < y1; ++y)
        for (int x = x0; x * tile_samples < x1; ++x) tiles.push_back(y * columns_ + x);
    return tiles;
}

void Tiles::take(Mark mark, int reach_low, int reach_high, int groups_per_tile, TileList& list) {
    flags_.bind_storage(0);
    list.buffer.bind_storage(1);
    list_program_.set("tiles", glm::ivec2(columns_, rows_));
    list_program_.set("flag_bit", static_cast<unsigned>(mark));
    list_program_.set("reach_low", reach_low);
    list_program_.set("reach_high", reach_high);
    list_program_.set("groups_per_tile", static_cast<unsigned>(groups_per_tile));
    list_program_.dispatch(1);
    gpu::barrier({gpu::Use::storage, gpu::Use::indirect, gpu::Use::buffer_transfer});
}

void Tiles::clear(Mark mark) {
    flags_.bind_storage(0);
    clear_program_.set("flag_bit", static_cast<unsigned>(mark));
    clear_program_.set("tile_count", count());
    clear_program_.dispatch((count() + 63) / 64);
    gpu::barrier({gpu::Use::storage, gpu::Use::buffer_transfer});
}

std::vector<bool> Tiles::read(Mark mark) const {
    const auto words = flags_.read_all<std::uint32_t>();
    std::vector<bool> marked(words.size());
    std::transform(words.begin(), words.end(), marked.begin(),
                   [mark](std::uint32_t w) { return (w & mark) != 0; });
    return marked;
}

}  // namespace talus
