#include "app/core/surroundings.h"

namespace talus::app {

StillPainter Surroundings::painter(render::Renderer& renderer, const Terrain& terrain,
                                   const render::ViewSettings& settings) {
    StillPainter painter = painter_of(renderer, terrain, settings);
    painter.begin = [this, settings](const render::Camera& camera, glm::ivec2 size) {
        tiles_.begin_still(backdrop_.camera_over_tiles(camera), size, settings.tolerance_px);
    };
    painter.draw = [this, draw = painter.draw](const render::Camera& camera, glm::ivec2 size) {
        tiles_.wait_for_still(backdrop_.camera_over_tiles(camera), size);
        backdrop_.note_change();
        draw(camera, size);
    };
    return painter;
}

HeightsBetween Surroundings::heights() const {
    const TiledTerrain& whole = tiles_.terrain();
    return [of_whole = heights_between(whole.tree, whole.bounds), shift = glm::dvec2(backdrop_.first())](
               glm::dvec2 first, glm::dvec2 last) { return of_whole(first + shift, last + shift); };
}

std::unique_ptr<Surroundings> surroundings_of(const Scene& scene, const Grid& grid,
                                              const std::optional<Georeference>& place) {
    if (!scene.whole) return nullptr;
    const std::optional<glm::ivec2> first = io::first_sample_in(scene.whole->file, grid, place);
    if (!first) return nullptr;
    return std::make_unique<Surroundings>(scene.whole, scene.view.whole("tiles.gpu_mib"), grid, *first);
}

}  // namespace talus::app
