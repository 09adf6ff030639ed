#include "app/core/overflight.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <thread>
#include <utility>

#include "sim/error.h"

namespace talus::app {
namespace {

// Whether the file has changed is asked no more often, and takes no more than a twentieth of the time.
constexpr std::chrono::seconds between_looks(2);
constexpr int share_of_looks = 20;

// A still for which no tile comes for so long is given up.
constexpr std::chrono::seconds longest_wait(20);

// Reads, and now and then sees whether the file has changed. For one thread.
ReadSamples watching(const io::TiledFile& file, std::atomic<bool>& changed) {
    using Clock = std::chrono::steady_clock;
    return [&file, &changed, read = file.make_reader(), next = Clock::now() + between_looks](
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

Overflight::Overflight(std::shared_ptr<const TiledTerrain> terrain, int gpu_mib,
                       const io::ColourImage& texture)
    : terrain_(std::move(terrain)),
      surface_(terrain_->tree, terrain_->bounds, slots_within(*terrain_, gpu_mib)),
      paging_(terrain_->tree, watching(terrain_->file, changed_)) {
    const ReadSamples read = terrain_->file.make_reader();
    std::vector<float> heights;
    for (const TileId& tile : terrain_->tree.coarsest_tiles()) {
        read(tile.level, terrain_->tree.samples_of(tile), heights);
        surface_.put(tile, heights);
    }
    renderer_.drape(texture.width, texture.height, std::as_bytes(std::span(texture.rgba)));
}

render::Drawn Overflight::draw(const render::Camera& camera, const render::ViewSettings& settings,
                               glm::ivec2 size) {
    const render::TileChoice& choice = paging_.follow(surface_, camera, size, settings.tolerance_px);
    asked_px_ = settings.tolerance_px;
    tolerance_px_ = choice.tolerance_px;
    Picture picture{camera, settings, size, choice.nodes, choice.drawn};
    if (drawn_ == picture) return render::Drawn::nothing;
    renderer_.draw(surface_, camera, settings, size.x, size.y);
    drawn_ = std::move(picture);
    return render::Drawn::everything;
}

StillPainter Overflight::painter(const render::ViewSettings& settings) {
    return {
        [this, settings](const render::Camera& camera, glm::ivec2 size) {
            forget();
            // One tolerance for all parts of a still, so that levels meet between them.
            still_px_ = surface_.look(camera, size, settings.tolerance_px).tolerance_px;
        },
        [this, settings](const render::Camera& camera, glm::ivec2 size) {
            auto end = std::chrono::steady_clock::now() + longest_wait;
            std::size_t before = 0;
            do {
                paging_.follow(surface_, camera, size, still_px_);
                const auto now = std::chrono::steady_clock::now();
                if (paging_.on_their_way() != std::exchange(before, paging_.on_their_way()))
                    end = now + longest_wait;
                if (now > end)
                    throw Error(fmt::format("'{}' gave no tile for {} s, and {} are missing in the picture",
                                            terrain_->file.path().string(), longest_wait.count(), before));
                std::this_thread::sleep_for(std::chrono::milliseconds(1));
            } while (paging_.on_their_way() > 0);
            renderer_.draw(surface_, camera, settings, size.x, size.y);
        },
        [this](int samples) { return refine(samples); },
        [this](glm::ivec2 size) { return renderer_.read_rgb(size.x, size.y); },
        [this](glm::ivec2 size) { return renderer_.read_depth(size.x, size.y); }};
}

std::optional<std::string> Overflight::take_message() {
    if (changed_ && !std::exchange(change_told_, true))
        return fmt::format(
            "'{}' was changed by another program since it was opened: open it again to see it as it is",
            terrain_->file.path().string());
    return paging_.take_message();
}

std::string Overflight::state() const {
    std::string text = tolerance_px_ > asked_px_
                           ? fmt::format("within {:.2f} px: for {:.2f} px there is not enough tiles.gpu_mib",
                                         tolerance_px_, asked_px_)
                           : fmt::format("within {:.2f} px", tolerance_px_);
    if (paging_.on_their_way() > 0)
        text = fmt::format("{} tiles on their way, then {}", paging_.on_their_way(), text);
    if (paging_.failed() > 0) text += fmt::format(", {} tiles cannot be read", paging_.failed());
    return text;
}

}  // namespace talus::app
