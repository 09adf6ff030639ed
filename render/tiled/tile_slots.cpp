#include "render/tiled/tile_slots.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <utility>

#include "sim/error.h"

namespace talus::render {

TileSlots::TileSlots(TileTree tree, std::vector<TileBounds> bounds, int slots)
    : tree_(std::move(tree)), bounds_(std::move(bounds)), slots_(static_cast<std::size_t>(slots)) {
    const glm::ivec2 coarsest = tree_.level(tree_.top_level()).tiles;
    if (slots <= coarsest.x * coarsest.y)
        throw Error(fmt::format("{} slots are too few for {} coarsest tiles and one more", slots,
                                coarsest.x * coarsest.y));
}

int TileSlots::slot_of(const TileId& tile) const {
    const auto found = slot_of_tile_.find(tree_.index_of(tile));
    return found == slot_of_tile_.end() ? -1 : found->second;
}

std::optional<TileId> TileSlots::tile_in(int slot) const {
    const TileId& tile = slots_[static_cast<std::size_t>(slot)].tile;
    return tile.level < 0 ? std::nullopt : std::optional(tile);
}

int TileSlots::slot_to_fill() const {
    int best = -1;
    for (int slot = 0; slot < count(); ++slot) {
        const Slot& one = slots_[static_cast<std::size_t>(slot)];
        if (one.tile.level < 0) return slot;
        if (one.tile.level == tree_.top_level()) continue;
        if (best < 0 || one.shown < slots_[static_cast<std::size_t>(best)].shown) best = slot;
    }
    return best;
}

int TileSlots::put(const TileId& tile) {
    int slot = slot_of(tile);
    if (slot < 0) slot = slot_to_fill();
    Slot& filled = slots_[static_cast<std::size_t>(slot)];
    if (filled.tile.level >= 0) slot_of_tile_.erase(tree_.index_of(filled.tile));
    filled = {tile, 2 * looks_ + 1};
    slot_of_tile_[tree_.index_of(tile)] = slot;
    return slot;
}

std::optional<int> TileSlots::put_aside(const TileId& tile) {
    if (slot_of(tile) >= 0 || !is_spare(slots_[static_cast<std::size_t>(slot_to_fill())]))
        return std::nullopt;
    const int slot = put(tile);
    // What the picture wants goes before it.
    slots_[static_cast<std::size_t>(slot)].shown = 2 * looks_ - 1;
    return slot;
}

bool TileSlots::is_spare(const Slot& slot) const {
    return slot.tile.level < 0 || (slot.tile.level < tree_.top_level() && slot.shown + 1 < 2 * looks_);
}

void TileSlots::clear() {
    for (Slot& slot : slots_) {
        if (slot.tile.level < 0 || slot.tile.level == tree_.top_level()) continue;
        slot_of_tile_.erase(tree_.index_of(slot.tile));
        slot.tile.level = -1;
    }
}

TileChoice TileSlots::choose(const Camera& camera, glm::ivec2 size, double tolerance_px) const {
    const std::size_t coarsest = tree_.count() - tree_.first_of(tree_.top_level());
    const std::size_t room = slots_.size() - coarsest;
    return choose_tiles(tree_, bounds_, camera, size, tolerance_px, room,
                        [&](const TileId& tile) { return slot_of(tile); });
}

const TileChoice& TileSlots::look(const Camera& camera, glm::ivec2 size, double tolerance_px) {
    ++looks_;
    choice_ = choose(camera, size, tolerance_px);
    // What stands for others is given away before what was asked for.
    const auto mark = [&](const std::vector<TileId>& tiles, std::uint64_t shown) {
        for (const TileId& tile : tiles) {
            const int slot = slot_of(tile);
            assert(slot >= 0 && "the coarsest tiles are put before the first look");
            slots_[static_cast<std::size_t>(slot)].shown = shown;
        }
    };
    mark(choice_.drawn, 2 * looks_);
    mark(choice_.needed, 2 * looks_ + 1);
    return choice_;
}

std::vector<TileId> TileSlots::look_ahead(const Camera& camera, glm::ivec2 size, double tolerance_px) {
    TileChoice later = choose(camera, size, tolerance_px);
    for (const TileId& tile : later.needed) {
        Slot& slot = slots_[static_cast<std::size_t>(slot_of(tile))];
        slot.shown = std::max(slot.shown, 2 * looks_ - 1);
    }
    const auto spare = static_cast<std::size_t>(
        std::count_if(slots_.begin(), slots_.end(), [&](const Slot& slot) { return is_spare(slot); }));
    later.wanted.resize(std::min(later.wanted.size(), spare));
    return std::move(later.wanted);
}

}  // namespace talus::render
