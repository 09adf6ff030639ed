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
      stamps_("tile stamps",
              static_cast<std::size_t>(columns_) * rows_ * tile_changes::tile_kinds * sizeof(std::uint32_t)),
      list_program_("sim/tile_list.comp") {
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

void Tiles::bind_for_stamping(gpu::Program& program) {
    stamps_.bind_storage(0);
    program.set("stamp_now", ++now_);
}

void Tiles::mark_all() {
    stamps_.fill(++now_);
}

void Tiles::list(std::uint32_t changes, Reader& reader, int reach_low, int reach_high, int groups_per_tile,
                 TileList& list) const {
    stamps_.bind_storage(0);
    list.buffer.bind_storage(1);
    list_program_.set("tiles", glm::ivec2(columns_, rows_));
    list_program_.set("changes", changes);
    list_program_.set("since", reader.read);
    list_program_.set("reach_low", reach_low);
    list_program_.set("reach_high", reach_high);
    list_program_.set("groups_per_tile", static_cast<unsigned>(groups_per_tile));
    list_program_.dispatch(1);
    gpu::barrier({gpu::Use::storage, gpu::Use::indirect, gpu::Use::buffer_transfer});
    reader.read = now_;
}

bool Tiles::changed_since(std::uint32_t changes, std::uint32_t since, const std::uint32_t* stamps_of_tile) {
    for (std::uint32_t kind = 0; kind < tile_changes::tile_kinds; ++kind)
        if ((changes >> kind & 1U) != 0 && stamps_of_tile[kind] > since) return true;
    return false;
}

std::vector<bool> Tiles::read(std::uint32_t changes, std::uint32_t since) const {
    const auto stamps = stamps_.read_all<std::uint32_t>();
    std::vector<bool> changed;
    for (std::size_t at = 0; at < stamps.size(); at += tile_changes::tile_kinds)
        changed.push_back(changed_since(changes, since, &stamps[at]));
    return changed;
}

}  // namespace talus
