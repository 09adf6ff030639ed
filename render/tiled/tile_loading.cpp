#include "render/tiled/tile_loading.h"

#include <algorithm>
#include <exception>
#include <mutex>
#include <thread>

namespace talus::render {
namespace {

// Tiles that are read before they go to the device together.
constexpr std::size_t at_once = 64;

}  // namespace

TileLoading::TileLoading(const std::function<ReadSamples()>& make_reader) {
    const unsigned threads = std::max(1U, std::thread::hardware_concurrency());
    for (unsigned i = 0; i < threads; ++i) readers_.push_back(make_reader());
}

void TileLoading::begin(TiledSurface& surface) {
    put(surface, surface.tree().coarsest_tiles());
}

const TileChoice& TileLoading::load(TiledSurface& surface, const Camera& camera, glm::ivec2 size,
                                    double tolerance_px) {
    for (;;) {
        const TileChoice& choice = surface.look(camera, size, tolerance_px);
        if (choice.wanted.empty()) return choice;
        put(surface, choice.wanted);
    }
}

void TileLoading::put(TiledSurface& surface, const std::vector<TileId>& tiles) {
    std::vector<std::vector<float>> heights(at_once);
    for (std::size_t first = 0; first < tiles.size(); first += at_once) {
        const std::size_t count = std::min(at_once, tiles.size() - first);
        std::exception_ptr failure;
        std::mutex failing;
        const auto read = [&](std::size_t thread) {
            try {
                for (std::size_t i = thread; i < count; i += readers_.size()) {
                    const TileId& tile = tiles[first + i];
                    readers_[thread](tile.level, surface.tree().samples_of(tile), heights[i]);
                }
            } catch (...) {
                const std::lock_guard lock(failing);
                failure = std::current_exception();
            }
        };
        std::vector<std::thread> threads;
        for (std::size_t i = 1; i < readers_.size(); ++i) threads.emplace_back(read, i);
        read(0);
        for (std::thread& thread : threads) thread.join();
        if (failure) std::rethrow_exception(failure);
        for (std::size_t i = 0; i < count; ++i) surface.put(tiles[first + i], heights[i]);
    }
}

}  // namespace talus::render
