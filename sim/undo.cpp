#include "sim/undo.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace talus {
namespace {

std::size_t layer_bytes(const gpu::Region& region, gpu::Format format) {
    return static_cast<std::size_t>(region.width) * region.height * gpu::texel_bytes(format);
}

Undo::KeptTile copy_tile(Terrain& terrain, int tile) {
    const gpu::Region region = terrain.tiles.region(tile);
    const auto layers = terrain.optional_layers();
    Undo::KeptTile kept;
    std::size_t bytes = layer_bytes(region, gpu::Format::rgba32f);
    for (const OptionalLayer& layer : layers)
        if (layer.front) bytes += layer_bytes(region, layer.format);
    kept.texels = gpu::Buffer("undo tile", bytes);
    terrain.solid.front.copy_to(kept.texels, 0, region);
    std::size_t at = layer_bytes(region, gpu::Format::rgba32f);
    for (std::size_t i = 0; i < layers.size(); ++i) {
        if (!layers[i].front) continue;
        layers[i].front->copy_to(kept.texels, at, layers[i].texels(region));
        at += layer_bytes(region, layers[i].format);
        kept.layers |= 1U << i;
    }
    return kept;
}

// A layer that was not there yet when the tile was kept was zero.
void put_back(const Undo::KeptTile& kept, Terrain& terrain, int tile) {
    const gpu::Region region = terrain.tiles.region(tile);
    terrain.solid.front.copy_from(kept.texels, 0, region);
    std::size_t at = layer_bytes(region, gpu::Format::rgba32f);
    const auto layers = terrain.optional_layers();
    for (std::size_t i = 0; i < layers.size(); ++i) {
        if (!layers[i].front) continue;
        const std::size_t bytes = layer_bytes(region, layers[i].format);
        if ((kept.layers >> i & 1U) != 0) {
            layers[i].front->copy_from(kept.texels, at, layers[i].texels(region));
            at += bytes;
        } else {
            const std::vector<std::byte> zeros(bytes);
            layers[i].front->write(layers[i].texels(region), zeros);
        }
    }
    terrain.refresh(region);
}

std::vector<gpu::Buffer> copies_of(const Books& books) {
    std::vector<gpu::Buffer> copies;
    copies.reserve(books.size());
    for (const gpu::Buffer* book : books) copies.emplace_back("undo books", book->bytes()).copy_from(*book);
    return copies;
}

}  // namespace

void Undo::open(std::string name, Terrain& terrain, const Books& books, const Journal& journal,
                Moment before) {
    undone_.clear();
    done_.push_back({std::move(name), {}, copies_of(books), std::move(before), journal.mark(), {}, 0});
    open_ = true;
    all_kept_ = false;
    // From here on the marks say what this entry changed.
    terrain.tiles.clear(Tiles::undo);
}

bool Undo::extends(const std::string& name) {
    if (done_.empty() || done_.back().name != name || !done_.back().tiles.empty()) return false;
    undone_.clear();
    return true;
}

void Undo::set_capacity(std::size_t bytes) {
    capacity_bytes_ = bytes;
    trim();
}

void Undo::keep(Terrain& terrain, const std::vector<int>& tiles) {
    Entry& entry = done_.back();
    for (const int tile : tiles) {
        if (entry.tiles.contains(tile)) continue;
        const auto kept = entry.tiles.emplace(tile, copy_tile(terrain, tile)).first;
        entry.bytes += kept->second.texels.bytes();
    }
}

void Undo::keep_all(Terrain& terrain) {
    if (all_kept_) return;
    std::vector<int> tiles(static_cast<std::size_t>(terrain.tiles.count()));
    std::iota(tiles.begin(), tiles.end(), 0);
    keep(terrain, tiles);
    all_kept_ = true;
}

void Undo::close(Terrain& terrain, const Journal& journal) {
    if (!open_) return;
    open_ = false;
    Entry& entry = done_.back();
    const Journal::Mark now = journal.mark();
    if (now.count == entry.mark.count && now.last == entry.mark.last) {
        done_.pop_back();
        return;
    }
    // A stroke kept only the tiles that it reached; after a run the device says which changed.
    const std::vector<bool> changed = all_kept_ ? terrain.tiles.read(Tiles::undo) : std::vector<bool>();
    for (auto tile = entry.tiles.begin(); tile != entry.tiles.end();) {
        if (!all_kept_ || changed[static_cast<std::size_t>(tile->first)]) {
            ++tile;
        } else {
            entry.bytes -= tile->second.texels.bytes();
            tile = entry.tiles.erase(tile);
        }
    }
    trim();
}

void Undo::trim() {
    while (done_.size() > 1 && bytes() > capacity_bytes_) done_.pop_front();
}

std::size_t Undo::bytes() const {
    std::size_t total = 0;
    const auto add = [&](const Entry& entry) {
        total += entry.bytes;
        for (const gpu::Buffer& book : entry.books) total += book.bytes();
    };
    std::for_each(done_.begin(), done_.end(), add);
    std::for_each(undone_.begin(), undone_.end(), add);
    return total;
}

void Undo::swap(Entry& entry, Terrain& terrain, const Books& books, Moment& now) {
    for (auto& [tile, kept] : entry.tiles) {
        KeptTile present = copy_tile(terrain, tile);
        put_back(kept, terrain, tile);
        // Layers may have come since.
        entry.bytes += present.texels.bytes();
        entry.bytes -= kept.texels.bytes();
        std::swap(kept, present);
    }
    std::vector<gpu::Buffer> present = copies_of(books);
    for (std::size_t i = 0; i < books.size(); ++i) {
        // A book that was begun after the act held nothing yet.
        if (i < entry.books.size())
            books[i]->copy_from(entry.books[i]);
        else
            books[i]->fill(0);
    }
    std::swap(entry.books, present);
    std::swap(entry.moment, now);
}

void Undo::undo(Terrain& terrain, const Books& books, Journal& journal, Moment& now) {
    Entry& entry = done_.back();
    entry.tail = journal.cut(entry.mark);
    swap(entry, terrain, books, now);
    undone_.push_back(std::move(entry));
    done_.pop_back();
}

void Undo::redo(Terrain& terrain, const Books& books, Journal& journal, Moment& now) {
    Entry& entry = undone_.back();
    journal.restore(entry.mark, entry.tail);
    entry.tail.clear();
    swap(entry, terrain, books, now);
    done_.push_back(std::move(entry));
    undone_.pop_back();
}

}  // namespace talus
