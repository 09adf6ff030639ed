#include "app/core/paged_tiles.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <utility>

#include "app/core/tile_waiting.h"

namespace talus::app {
namespace {

// Whether the file has changed is asked no more often, and takes no more than a twentieth of the time.
constexpr std::chrono::seconds between_looks(2);
constexpr int share_of_looks = 20;

// Reads, and now and then sees whether the file has changed. For one thread.
ReadSamples watching(const TiledTerrain& terrain, std::atomic<bool>& changed) {
    // A sketch is followed by what is there when it has been made ready, and meanwhile overviews come beside
    // the file.
    if (!terrain.is_measured) return terrain.make_reader();
    using Clock = std::chrono::steady_clock;
    return
        [&file = terrain.file, &changed, read = terrain.make_reader(), next = Clock::now() + between_looks](
            int level, const TileSamples& samples, std::vector<float>& heights) mutable {
            const Clock::time_point begin = Clock::now();
            if (!changed && begin >= next) {
                changed = file.has_changed();
                const Clock::duration took = Clock::now() - begin;
                next = begin + std::max<Clock::duration>(between_looks, share_of_looks * took);
            }
            read(level, samples, heights);
        };
}

}  // namespace

PagedTiles::PagedTiles(std::shared_ptr<const TiledTerrain> terrain, int gpu_mib)
    : terrain_(std::move(terrain)),
      surface_(terrain_->tree, terrain_->bounds, slots_within(*terrain_, gpu_mib)),
      paging_(terrain_->tree, watching(*terrain_, changed_)) {
    const ReadSamples read = terrain_->make_reader();
    std::vector<float> heights;
    for (const TileId& tile : terrain_->tree.coarsest_tiles()) {
        read(tile.level, terrain_->tree.samples_of(tile), heights);
        surface_.put(tile, heights);
    }
}

bool PagedTiles::follow(const render::Camera& camera, glm::ivec2 size, double tolerance_px) {
    const render::TileChoice& choice = paging_.follow(surface_, camera, size, tolerance_px);
    asked_px_ = tolerance_px;
    tolerance_px_ = choice.tolerance_px;
    if (nodes_ == choice.nodes && drawn_ == choice.drawn) return false;
    nodes_ = choice.nodes;
    drawn_ = choice.drawn;
    return true;
}

void PagedTiles::begin_still(const render::Camera& camera, glm::ivec2 size, double tolerance_px) {
    still_px_ = surface_.look(camera, size, tolerance_px).tolerance_px;
}

void PagedTiles::wait_for_still(const render::Camera& camera, glm::ivec2 size) {
    wait_for_tiles(terrain_->file.path(), [&] {
        follow(camera, size, still_px_);
        return paging_.on_their_way();
    });
}

std::optional<std::string> PagedTiles::take_message() {
    if (changed_ && !std::exchange(change_told_, true))
        return fmt::format(
            "'{}' was changed by another program since it was opened: open it again to see it as it is",
            terrain_->file.path().string());
    return paging_.take_message();
}

std::string PagedTiles::state() const {
    std::string text = !terrain_->is_measured ? "a sketch, no bound on its error is known"
                       : tolerance_px_ > asked_px_
                           ? fmt::format("within {:.2f} px: for {:.2f} px there is not enough tiles.gpu_mib",
                                         tolerance_px_, asked_px_)
                           : fmt::format("within {:.2f} px", tolerance_px_);
    if (paging_.on_their_way() > 0)
        text = fmt::format("{} tiles on their way, then {}", paging_.on_their_way(), text);
    if (paging_.failed() > 0) text += fmt::format(", {} tiles cannot be read", paging_.failed());
    return text;
}

}  // namespace talus::app
