#include "sim/terrain/tiles.h"

#include <algorithm>
#include <array>
#include <atomic>

namespace talus {

namespace {

std::uint32_t next_round() {
    static std::atomic<std::uint32_t> rounds = 0;
    return ++rounds;
}

}  // namespace

TileList::TileList(int tile_count)
    : buffer("tile list", (4 + static_cast<std::size_t>(tile_count)) * sizeof(std::uint32_t)) {
    buffer.fill(0);
}

Tiles::Tiles(const Grid& grid, std::uint32_t last_number)
    : grid_(grid),
      columns_((grid.nx + tile_samples - 1) / tile_samples),
      rows_((grid.ny + tile_samples - 1) / tile_samples),
      stamps_("tile stamps",
              static_cast<std::size_t>(columns_) * rows_ * tile_changes::tile_kinds * sizeof(std::uint32_t)),
      last_number_(last_number),
      round_(next_round()),
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

std::uint32_t Tiles::next() {
    if (now_ < last_number_) return ++now_;
    // The stamps of the round before would be later than all that follow.
    round_ = next_round();
    now_ = 1;
    stamps_.fill(now_);
    return ++now_;
}

void Tiles::bind_for_stamping(gpu::Program& program) {
    program.set("stamp_now", next());
    program.bind_storage("TileStamps", stamps_);
}

void Tiles::mark_all() {
    stamps_.fill(next());
}

void Tiles::list(std::uint32_t changes, Reader& reader, int reach_low, int reach_high, int groups_per_tile,
                 TileList& list) const {
    list_program_.bind_storage("TileStamps", stamps_);
    list_program_.bind_storage("TileList", list.buffer);
    list_program_.set("tiles", glm::ivec2(columns_, rows_));
    list_program_.set("changes", changes);
    list_program_.set("since", since(reader));
    list_program_.set("reach_low", reach_low);
    list_program_.set("reach_high", reach_high);
    list_program_.set("groups_per_tile", static_cast<unsigned>(groups_per_tile));
    list_program_.dispatch(1);
    gpu::barrier({gpu::Use::storage, gpu::Use::indirect, gpu::Use::buffer_transfer});
    reader = reader_now();
}

bool Tiles::has_changed(std::uint32_t changes, const Reader& reader,
                        const std::uint32_t* stamps_of_tile) const {
    for (std::uint32_t kind = 0; kind < tile_changes::tile_kinds; ++kind)
        if ((changes >> kind & 1U) != 0 && stamps_of_tile[kind] > since(reader)) return true;
    return false;
}

std::vector<bool> Tiles::read(std::uint32_t changes, const Reader& reader) const {
    const auto stamps = stamps_.read_all<std::uint32_t>();
    std::vector<bool> changed;
    for (std::size_t at = 0; at < stamps.size(); at += tile_changes::tile_kinds)
        changed.push_back(has_changed(changes, reader, &stamps[at]));
    return changed;
}

}  // namespace talus
