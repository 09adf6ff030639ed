#include "sim/tile_changes.h"

#include <algorithm>
#include <chrono>
#include <cstring>
#include <utility>

#include "sim/error.h"
#include "sim/terrain/layers.h"

namespace talus {
namespace {

constexpr std::size_t tiles_a_chunk = 64;

// Walks over the layers of a tile in the order in which buffers hold them: the solid, then the optional ones
// whose bit is set. `act` gets the image, its texels there, how many bytes they are, and the layer's bit (the
// solid's is 0).
template <typename Act>
void each_layer(Terrain& terrain, int tile, unsigned layers, Act&& act) {
    const gpu::Region region = terrain.tiles.region(tile);
    const auto samples = static_cast<std::size_t>(region.width) * region.height;
    act(terrain.solid.front, region, samples * gpu::texel_bytes(gpu::Format::rgba32f), 0U);
    for (std::size_t i = 0; i < talus::layers().size(); ++i) {
        if ((layers >> i & 1U) == 0) continue;
        DeviceLayer& layer = *(terrain.*talus::layers()[i].image);
        act(layer.front, layer.texels(region), samples * gpu::texel_bytes(layer.front.format()), 1U << i);
    }
}

// Bytes of a tile with these layers.
std::size_t tile_bytes(Terrain& terrain, int tile, unsigned layers) {
    std::size_t sum = 0;
    each_layer(terrain, tile, layers,
               [&](const gpu::Texture&, const gpu::Region&, std::size_t bytes, unsigned) { sum += bytes; });
    return sum;
}

unsigned layers_of(Terrain& terrain) {
    unsigned there = 0;
    for (std::size_t i = 0; i < layers().size(); ++i)
        if (layers()[i].is_optional() && terrain.*layers()[i].image) there |= 1U << i;
    return there;
}

void copy_tile(Terrain& terrain, int tile, unsigned layers, const gpu::Buffer& target, std::size_t at) {
    each_layer(terrain, tile, layers,
               [&](const gpu::Texture& image, const gpu::Region& texels, std::size_t bytes, unsigned) {
                   image.copy_to(target, at, texels);
                   at += bytes;
               });
}

void put_back(Terrain& terrain, int tile, unsigned layers, const gpu::Buffer& source, std::size_t at) {
    each_layer(terrain, tile, layers,
               [&](gpu::Texture& image, const gpu::Region& texels, std::size_t bytes, unsigned) {
                   image.copy_from(source, at, texels);
                   at += bytes;
               });
    terrain.refresh(terrain.tiles.region(tile));
}

// Copies a kept tile. Layers that did not exist when it was kept are filled with zeros.
void copy_kept(Terrain& terrain, int tile, const KeptTile& kept, unsigned layers, gpu::Buffer& target,
               std::size_t at) {
    std::size_t from = 0;
    each_layer(terrain, tile, layers,
               [&](const gpu::Texture&, const gpu::Region&, std::size_t bytes, unsigned bit) {
                   if ((kept.layers & bit) == bit) {
                       target.copy_part(at, kept.texels, from, bytes);
                       from += bytes;
                   } else {
                       target.write(at, std::vector<std::byte>(bytes));
                   }
                   at += bytes;
               });
}

void flip(std::byte* words, const std::byte* bits, std::size_t bytes) {
    for (std::size_t i = 0; i < bytes; ++i) words[i] ^= bits[i];
}

}  // namespace

KeptTile copy_tile(Terrain& terrain, int tile) {
    KeptTile kept;
    kept.layers = layers_of(terrain);
    kept.texels = gpu::Buffer("undo tile", tile_bytes(terrain, tile, kept.layers));
    copy_tile(terrain, tile, kept.layers, kept.texels, 0);
    return kept;
}

TileChanges::TileChanges(Terrain& terrain, std::map<int, KeptTile>& before) {
    const unsigned layers = layers_of(terrain);
    while (!before.empty()) {
        auto chunk = std::make_unique<Chunk>();
        chunk->layers = layers;
        for (const auto& [tile, kept] : before) {
            if (chunk->tiles.size() == tiles_a_chunk) break;
            chunk->tiles.push_back(tile);
            chunk->raw_bytes += tile_bytes(terrain, tile, layers);
        }
        gpu::Buffer both("undo before and after", 2 * chunk->raw_bytes);
        std::size_t at = 0;
        for (const int tile : chunk->tiles) {
            copy_kept(terrain, tile, before.at(tile), layers, both, at);
            copy_tile(terrain, tile, layers, both, chunk->raw_bytes + at);
            at += tile_bytes(terrain, tile, layers);
            before.erase(tile);
        }
        chunk->before_and_after.start(std::move(both));
        chunks_.push_back(std::move(chunk));
    }
}

void TileChanges::pack(Chunk& chunk, const std::vector<float>& words) {
    chunk.packing = std::async(std::launch::async, [bytes = chunk.raw_bytes, words] {
        std::vector<std::byte> bits(bytes);
        const auto* both = reinterpret_cast<const std::byte*>(words.data());
        std::memcpy(bits.data(), both, bytes);
        flip(bits.data(), both + bytes, bytes);
        return PackedBytes(bits);
    });
}

void TileChanges::poll() {
    // One after the other: packing shall not take the simulation's threads.
    for (const auto& chunk : chunks_) {
        if (chunk->packing.valid()) {
            if (chunk->packing.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return;
            chunk->packed = chunk->packing.get();
        } else if (chunk->before_and_after.pending()) {
            const auto words = chunk->before_and_after.poll();
            if (words) pack(*chunk, *words);
            return;
        }
    }
}

void TileChanges::settle() {
    for (const auto& chunk : chunks_) {
        if (chunk->before_and_after.pending()) pack(*chunk, chunk->before_and_after.wait());
        if (chunk->packing.valid()) chunk->packed = chunk->packing.get();
    }
}

bool TileChanges::is_settled() const {
    return std::none_of(chunks_.begin(), chunks_.end(), [](const auto& chunk) {
        return chunk->packing.valid() || chunk->before_and_after.pending();
    });
}

void TileChanges::apply(Terrain& terrain) {
    settle();
    for (const auto& chunk : chunks_) {
        gpu::Buffer texels("undo tiles", chunk->raw_bytes);
        const auto each_tile = [&](auto&& act) {
            std::size_t at = 0;
            for (const int tile : chunk->tiles) {
                act(tile, at);
                at += tile_bytes(terrain, tile, chunk->layers);
            }
        };
        each_tile([&](int tile, std::size_t at) { copy_tile(terrain, tile, chunk->layers, texels, at); });
        std::vector<std::byte> words = texels.read_all<std::byte>();
        const std::vector<std::byte> bits = chunk->packed.unpack();
        if (bits.size() != words.size())
            throw Error("this act was lost from the history: it could not be packed");
        flip(words.data(), bits.data(), words.size());
        texels.write(0, words);
        each_tile([&](int tile, std::size_t at) { put_back(terrain, tile, chunk->layers, texels, at); });
    }
}

std::size_t TileChanges::bytes() const {
    std::size_t total = 0;
    for (const auto& chunk : chunks_) {
        const bool settled = !chunk->packing.valid() && !chunk->before_and_after.pending();
        total += settled ? chunk->packed.bytes() : 2 * chunk->raw_bytes;
    }
    return total;
}

}  // namespace talus
