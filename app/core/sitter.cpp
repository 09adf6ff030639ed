#include "app/core/sitter.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "app/core/calibration.h"
#include "app/core/legend_scale.h"
#include "app/core/opening.h"
#include "app/core/paged_photo.h"
#include "app/core/surroundings.h"
#include "render/tiled/tile_loading.h"
#include "render/tiled/tiled_renderer.h"
#include "sim/error.h"
#include "sim/terrain/terrain.h"

namespace talus::app {
namespace {

Sitter whole_sitter(const SceneRequest& request, const gpu::Device& device) {
    struct Held {
        Scene scene;
        Terrain terrain;
        render::Renderer renderer;
        std::unique_ptr<Surroundings> around;  // null: nothing stands around
        std::unique_ptr<PagedPhoto> photo;     // null: none lies over it
        Held(Scene made, double patch_px)
            : scene(std::move(made)), terrain(scene.document.state), renderer(terrain, patch_px) {}
    };
    auto held = std::make_shared<Held>(open_scene(request, on_terminal()), patch_pixels(device));
    suggest_scale_end(held->scene.view, held->scene.simulation, held->terrain);
    const Scene& scene = held->scene;
    const std::vector<float> ground = scene.document.state.ground();
    const auto [low, high] = std::minmax_element(ground.begin(), ground.end());
    const render::ViewSettings settings = render::view_settings(scene.view, scene.simulation);
    drape(held->renderer, scene);
    Sitter sitter(scene.view);
    sitter.grid = scene.document.state.grid;
    sitter.lowest_m = *low;
    sitter.highest_around_m = sitter.highest_m = *high;
    sitter.method = settings.method;
    sitter.samples = scene.view.whole("render.samples");
    sitter.legends = render::legend_of(settings, *low, *high);
    sitter.notes = scene.document.notes;
    sitter.cameras = scene.workspace.cameras;
    held->around = surroundings_of(scene, sitter.grid, scene.document.state.georeference);
    if (held->around) {
        held->renderer.stand_before(&held->around->backdrop());
        const glm::dvec2 range_m = held->around->backdrop().range_m();
        sitter.highest_around_m = range_m.y;
        sitter.legends = render::legend_of(settings, range_m.x, range_m.y);
    }
    sitter.painter = held->around ? held->around->painter(held->renderer, held->terrain, settings)
                                  : painter_of(held->renderer, held->terrain, settings);
    held->photo =
        photo_over(scene.draping, sitter.grid, scene.document.state.georeference,
                   held->around ? held->around->heights() : heights_between(sitter.grid, ground), scene.view);
    if (held->photo) {
        held->renderer.lay(held->photo->laid());
        if (held->around) {
            held->photo->stand_within(scene.whole->tree.grid(), scene.whole->file.georeference());
            held->around->backdrop().lay(held->photo->laid_around());
        }
        sitter.painter = with_photo(sitter.painter, *held->photo, settings.view, Missing::refused);
        sitter.photo_px = [photo = held->photo.get()] { return photo->largest_px(); };
    }
    sitter.held = held;
    return sitter;
}

Sitter tiled_sitter(const SceneRequest& request) {
    struct Held {
        std::shared_ptr<const TiledTerrain> terrain;
        render::TiledSurface surface;
        render::TileLoading loading;
        render::TiledRenderer renderer;
        std::unique_ptr<PagedPhoto> photo;
        render::ViewSettings settings;
        TiledFigures figures;
        double tolerance_px = 0;  // of the still that is drawn
        Held(std::shared_ptr<const TiledTerrain> opened, int slots)
            : terrain(std::move(opened)),
              surface(terrain->tree, terrain->bounds, slots),
              loading([this] { return terrain->make_reader(); }) {}
    };
    const TiledScene scene = open_tiled_scene(request, on_terminal());
    const Parameters& view = scene.parameters.view;
    const render::ViewSettings settings = render::view_settings(view, scene.parameters.simulation);
    const int slots = slots_within(*scene.terrain, view.whole("tiles.gpu_mib"));
    auto held = std::make_shared<Held>(scene.terrain, slots);
    held->settings = settings;
    held->figures = {0, held->settings.tolerance_px, 0, held->surface.bytes()};
    held->loading.begin(held->surface);
    const io::ColourImage& picture = scene.draping.picture;
    held->renderer.drape(picture.width, picture.height, std::as_bytes(std::span(picture.rgba)));
    Sitter sitter(view);
    sitter.grid = held->terrain->tree.grid();
    sitter.lowest_m = held->terrain->lowest_m;
    sitter.highest_around_m = sitter.highest_m = held->terrain->highest_m;
    sitter.method = "tiled";
    sitter.samples = view.whole("render.samples");
    sitter.legends = render::tiled_legend_of(held->settings, held->surface);
    sitter.notes = held->terrain->notes;
    Held& here = *held;
    sitter.painter = {
        [&here](const render::Camera& camera, glm::ivec2 size) {
            // One tolerance for all parts of a still, so that levels meet between them.
            here.tolerance_px = here.surface.look(camera, size, here.settings.tolerance_px).tolerance_px;
        },
        [&here](const render::Camera& camera, glm::ivec2 size) {
            const render::TileChoice& choice =
                here.loading.load(here.surface, camera, size, here.tolerance_px);
            here.figures.drawn = std::max(here.figures.drawn, choice.drawn.size());
            here.figures.tolerance_px = std::max(here.figures.tolerance_px, choice.tolerance_px);
            here.renderer.draw(here.surface, camera, here.settings, size.x, size.y);
        },
        [&here](int samples) { return here.renderer.refine(here.surface, samples); },
        [&here](glm::ivec2 size) { return here.renderer.read_rgb(size.x, size.y); },
        [&here](glm::ivec2 size) { return here.renderer.read_depth(size.x, size.y); }};
    held->photo = photo_over(scene.draping, sitter.grid, scene.terrain->file.georeference(),
                             heights_between(scene.terrain->tree, scene.terrain->bounds), view);
    if (held->photo) {
        held->renderer.lay(held->photo->laid());
        sitter.painter = with_photo(sitter.painter, *held->photo, settings.view, Missing::refused);
        sitter.photo_px = [photo = held->photo.get()] { return photo->largest_px(); };
    }
    sitter.tiles = [&here] { return here.figures; };
    sitter.held = held;
    return sitter;
}

}  // namespace

Sitter make_sitter(const SceneRequest& request, const gpu::Device& device) {
    if (is_in_tiles(request)) return tiled_sitter(request);
    return whole_sitter(request, device);
}

}  // namespace talus::app
