#include "app/core/overflight.h"

#include <fmt/format.h>

#include <chrono>
#include <thread>
#include <utility>

namespace talus::app {
namespace {

// Whether the file has changed is asked no more often.
constexpr std::chrono::seconds between_looks(2);

// Reads, and now and then sees whether the file has changed. For one thread.
ReadSamples watching(const TiledTerrain& terrain, std::shared_ptr<std::atomic<bool>> changed) {
    return [&file = terrain.file, read = terrain.file.make_reader(), changed = std::move(changed),
            next = std::chrono::steady_clock::now()](int level, const TileSamples& samples,
                                                     std::vector<float>& heights) mutable {
        if (!*changed && std::chrono::steady_clock::now() >= next) {
            *changed = file.has_changed();
            next = std::chrono::steady_clock::now() + between_looks;
        }
        read(level, samples, heights);
    };
}

}  // namespace

Overflight::Overflight(std::shared_ptr<const TiledTerrain> terrain, int gpu_mib,
                       const io::ColourImage& texture)
    : terrain_(std::move(terrain)),
      surface_(terrain_->tree, terrain_->bounds, slots_within(*terrain_, gpu_mib)),
      changed_(std::make_shared<std::atomic<bool>>(false)),
      paging_(terrain_->tree, watching(*terrain_, changed_)) {
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
    return {{},
            [this, settings](const render::Camera& camera, glm::ivec2 size) {
                do {
                    forget();
                    paging_.follow(surface_, camera, size, settings.tolerance_px);
                    std::this_thread::sleep_for(std::chrono::milliseconds(1));
                } while (paging_.on_their_way() > 0);
                renderer_.draw(surface_, camera, settings, size.x, size.y);
            },
            [this](int samples) { return refine(samples); },
            [this](glm::ivec2 size) { return renderer_.read_rgb(size.x, size.y); },
            [this](glm::ivec2 size) { return renderer_.read_depth(size.x, size.y); }};
}

std::optional<std::string> Overflight::take_message() {
    if (*changed_ && !std::exchange(change_told_, true))
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
