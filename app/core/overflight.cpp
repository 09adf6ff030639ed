#include "app/core/overflight.h"

#include <utility>

namespace talus::app {

Overflight::Overflight(std::shared_ptr<const TiledTerrain> terrain, int gpu_mib,
                       const io::ColourImage& picture)
    : tiles_(std::move(terrain), gpu_mib) {
    renderer_.drape(picture.width, picture.height, std::as_bytes(std::span(picture.rgba)));
}

render::Drawn Overflight::draw(const render::Camera& camera, const render::ViewSettings& settings,
                               glm::ivec2 size) {
    const bool other_tiles = tiles_.follow(camera, size, settings.tolerance_px);
    const Picture picture{camera, settings, size, photo_changes_};
    if (!other_tiles && drawn_ == picture) return render::Drawn::nothing;
    renderer_.draw(surface(), camera, settings, size.x, size.y);
    drawn_ = picture;
    return render::Drawn::everything;
}

StillPainter Overflight::painter(const render::ViewSettings& settings) {
    return {[this, settings](const render::Camera& camera, glm::ivec2 size) {
                forget();
                tiles_.begin_still(camera, size, settings.tolerance_px);
            },
            [this, settings](const render::Camera& camera, glm::ivec2 size) {
                tiles_.wait_for_still(camera, size);
                renderer_.draw(surface(), camera, settings, size.x, size.y);
            },
            [this](int samples) { return refine(samples); },
            [this](glm::ivec2 size) { return renderer_.read_rgb(size.x, size.y); },
            [this](glm::ivec2 size) { return renderer_.read_depth(size.x, size.y); }};
}

}  // namespace talus::app
