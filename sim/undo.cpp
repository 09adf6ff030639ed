#include "sim/undo.h"

#include <algorithm>
#include <cassert>
#include <iterator>
#include <numeric>
#include <utility>

namespace talus {
std::size_t Undo::Entry::bytes() const {
    // Parameters and what else every entry has.
    constexpr std::size_t moment_bytes = 16U << 10U;
    return moment_bytes + changes.bytes() + snapshot.books.bytes() +
           (snapshot.terrain ? snapshot.terrain->bytes() : 0);
}

void Undo::open(std::string name, Terrain& terrain, const Journal& journal, Snapshot before,
                std::string parameter) {
    done_.push_back({std::move(name), std::move(parameter), {}, {}, std::move(before), journal.mark(), {}});
    dropped_ = std::exchange(undone_, {});
    open_ = true;
    all_kept_ = false;
    opened_at_ = terrain.tiles.reader_now();
}

bool Undo::extends(const std::string& parameter, const std::string& name) {
    if (done_.empty() || done_.back().parameter != parameter || !done_.back().changes.empty() ||
        done_.back().snapshot.terrain)
        return false;
    done_.back().name = name;
    undone_.clear();
    return true;
}

void Undo::set_capacity(std::size_t bytes) {
    capacity_bytes_ = bytes;
    trim();
}

void Undo::keep(Terrain& terrain, const std::vector<int>& tiles) {
    Entry& entry = done_.back();
    if (entry.snapshot.terrain) return;
    for (const int tile : tiles)
        if (!entry.kept.contains(tile)) entry.kept.emplace(tile, copy_tile(terrain, tile));
}

void Undo::keep_all(Terrain& terrain) {
    if (all_kept_) return;
    std::vector<int> tiles(static_cast<std::size_t>(terrain.tiles.count()));
    std::iota(tiles.begin(), tiles.end(), 0);
    keep(terrain, tiles);
    all_kept_ = true;
}

void Undo::keep_terrain(PackedTerrain before) {
    done_.back().snapshot.terrain = std::move(before);
}

bool Undo::is_empty(const Journal& journal) const {
    const Journal::Mark now = journal.mark();
    return now.count == done_.back().mark.count && now.last == done_.back().mark.last;
}

void Undo::close(Terrain& terrain, const Journal& journal) {
    if (!open_) return;
    open_ = false;
    Entry& entry = done_.back();
    if (is_empty(journal)) {
        done_.pop_back();
        undone_ = std::exchange(dropped_, {});
        return;
    }
    dropped_.clear();
    // A stroke kept only the tiles that it reached; after a run the device says which changed.
    if (all_kept_) {
        const std::vector<bool> changed = terrain.tiles.read(Tiles::anything, opened_at_);
        std::erase_if(entry.kept,
                      [&](const auto& kept) { return !changed[static_cast<std::size_t>(kept.first)]; });
    }
    // One entry at a time waits to be packed.
    for (std::size_t i = 0; i + 1 < done_.size(); ++i) done_[i].changes.settle();
    entry.changes = TileChanges(terrain, entry.kept);
    trim();
}

void Undo::abandon() {
    if (!open_) return;
    open_ = false;
    done_.pop_back();
    undone_ = std::exchange(dropped_, {});
}

void Undo::poll() {
    if (done_.empty() || open_ || done_.back().changes.is_settled()) return;
    done_.back().changes.poll();
    trim();
}

void Undo::settle() {
    if (done_.empty() || open_) return;
    done_.back().changes.settle();
    trim();
}

void Undo::trim() {
    // The newest entry's final size is unknown until it is packed: trimming waits.
    const auto fits = [&] { return bytes() <= capacity_bytes_ || !done_.back().changes.is_settled(); };
    while (!done_.empty() && !open_ && !fits()) done_.pop_front();
    while (!undone_.empty() && bytes() > capacity_bytes_) undone_.erase(undone_.begin());
}

std::vector<std::string> Undo::done() const {
    std::vector<std::string> names;
    std::transform(done_.begin(), done_.end(), std::back_inserter(names),
                   [](const Entry& entry) { return entry.name; });
    return names;
}

std::vector<std::string> Undo::undone() const {
    std::vector<std::string> names;
    std::transform(undone_.rbegin(), undone_.rend(), std::back_inserter(names),
                   [](const Entry& entry) { return entry.name; });
    return names;
}

std::size_t Undo::bytes() const {
    std::size_t total = 0;
    const auto add = [&](const Entry& entry) { total += entry.bytes(); };
    std::for_each(done_.begin(), done_.end(), add);
    std::for_each(undone_.begin(), undone_.end(), add);
    return total;
}

Snapshot Undo::undo(Terrain& terrain, Journal& journal, Snapshot now) {
    Entry& entry = done_.back();
    assert(entry.snapshot.terrain.has_value() == now.terrain.has_value());
    if (!entry.snapshot.terrain) entry.changes.apply(terrain);
    std::swap(entry.snapshot, now);
    entry.tail = journal.cut(entry.mark);
    undone_.push_back(std::move(entry));
    done_.pop_back();
    return now;
}

Snapshot Undo::redo(Terrain& terrain, Journal& journal, Snapshot now) {
    Entry& entry = undone_.back();
    assert(entry.snapshot.terrain.has_value() == now.terrain.has_value());
    if (!entry.snapshot.terrain) entry.changes.apply(terrain);
    std::swap(entry.snapshot, now);
    journal.restore(entry.mark, entry.tail);
    entry.tail.clear();
    done_.push_back(std::move(entry));
    undone_.pop_back();
    return now;
}

}  // namespace talus
