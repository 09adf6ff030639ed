#include "app/core/run_pictures.h"
#include "app/core/first_look.h"

#include <algorithm>

#include "app/core/calibration.h"
#include "app/core/legend_scale.h"
#include "app/core/paged_photo.h"

namespace talus::app {

struct RunPictures::Easel {
    Easel(const Scene& scene, Simulation& simulation, const gpu::Device& device,
          const render::ViewSettings& settings, const std::vector<float>& ground_m)
        : renderer(simulation.terrain(), patch_pixels(device)),
          painter(painter_of(renderer, simulation.terrain(), settings)) {
        const Grid& grid = simulation.terrain().grid();
        drape(renderer, scene);
        photo = photo_over(scene.draping, grid, simulation.moment_state().georeference,
                           heights_between(grid, ground_m), scene.view);
        if (!photo) return;
        renderer.lay(photo->laid());
        painter = with_photo(painter, *photo, settings.view, Missing::refused);
    }

    render::Renderer renderer;
    StillPainter painter;
    std::unique_ptr<PagedPhoto> photo;
};

RunPictures::RunPictures(const Scene& scene, Simulation& simulation, const gpu::Device& device,
                         glm::ivec2 size)
    : size_(size), samples_(scene.view.whole("render.samples")) {
    Parameters view = scene.view;
    suggest_scale_end(view, simulation.parameters(), simulation.terrain());
    const render::ViewSettings settings = render::view_settings(view, simulation.parameters());
    const std::vector<float> ground_m = simulation.terrain().ground.read_all<float>();
    const auto [low, high] = std::minmax_element(ground_m.begin(), ground_m.end());
    first_look_ = app::first_look(scene.view, simulation.terrain().grid(), {*low, *high},
                                  static_cast<double>(size.x) / size.y);
    legends_ = render::legend_of(settings, *low, *high);
    easel_ = std::make_unique<Easel>(scene, simulation, device, settings, ground_m);
}

RunPictures::~RunPictures() = default;

std::vector<std::uint8_t> RunPictures::take(const render::Camera& camera) {
    return draw_still(easel_->painter, camera, legends_, size_, samples_).rgb;
}

}  // namespace talus::app
