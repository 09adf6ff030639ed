#include "app/claims/picture_agreement.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "app/claims/differing_bits.h"
#include "render/hits_target.h"
#include "render/methods/method.h"
#include "render/overview.h"
#include "render/survey.h"
#include "sim/error.h"
#include "sim/passes/brush.h"
#include "sim/simulation.h"
#include "sim/simulation_parameters.h"
#include "sim/terrain/generate.h"

namespace talus::claims {
namespace {

Dab random_dab(const Grid& grid, std::mt19937& random, double reach_m, double amount_m, double height_m) {
    std::uniform_real_distribution<double> unit(0, 1);
    Dab dab;
    dab.effect = effect_of(static_cast<BrushMode>(random() % 4));
    dab.x_m = grid.width_m() * (1.1 * unit(random) - 0.05);
    dab.y_m = grid.height_m() * (1.1 * unit(random) - 0.05);
    dab.radius_m = 5 + reach_m * unit(random);
    dab.falloff = unit(random);
    dab.amount_m = amount_m * unit(random);
    dab.blend = unit(random);
    dab.target_m = height_m * unit(random);
    return dab;
}

struct Shown {
    Shown(const Grid& grid, const std::vector<float>& heights)
        : simulation(bedrock_terrain(grid, heights), Parameters(simulation_parameters()), 64U << 20U),
          renderer(simulation.terrain(), 16) {}
    Simulation simulation;
    render::Renderer renderer;
};

}  // namespace

SurveyError survey_error(const Grid& grid, const std::vector<float>& heights, const std::string& method,
                         double tolerance_px, glm::ivec2 size, double patch_pixels) {
    Terrain terrain(bedrock_terrain(grid, heights));
    render::Pyramid pyramid(terrain);
    pyramid.refresh(terrain);
    render::HitsTarget target(size.x, size.y);
    render::Measure measure(grid, heights);
    const render::Method draw = render::method_named(method).make(render::Detail::kind);
    // Tolerance 0 allows a thousandth of a pixel: a ray that grazes a crest changes its hit by metres in
    // less.
    const double limit_px = std::max(tolerance_px, 1e-3);
    SurveyError found;
    for (const render::NamedCamera& view : render::survey(grid, heights)) {
        draw({terrain, pyramid, view.camera, size.x, size.y, tolerance_px, patch_pixels,
              target.framebuffer()});
        std::vector<float> distances;
        for (const glm::vec2 hit : target.hits().read_all<glm::vec2>()) {
            distances.push_back(hit.x);
            if (std::isfinite(hit.x)) ++found.kinds[static_cast<std::size_t>(std::clamp(hit.y, 0.0F, 3.0F))];
        }
        const render::PictureError error = measure.compare(view.camera, size.x, size.y, distances, limit_px);
        if (error.beyond > 0) found.beyond.push_back(view.name);
        found.all.pixels_hit += error.pixels_hit;
        found.all.beyond += error.beyond;
        found.all.wrong_coverage += error.wrong_coverage;
        found.all.silhouettes_missed += error.silhouettes_missed;
        found.all.largest_px = std::max(found.all.largest_px, error.largest_px);
    }
    return found;
}

std::size_t pyramid_texels_differing(const Grid& grid, int dabs) {
    Terrain terrain(bedrock_terrain(grid, generate_heights(grid, {"hills", 1, 300})));
    render::Pyramid refreshed(terrain);
    refreshed.refresh(terrain);
    Brush brush(terrain);
    std::mt19937 random(3);
    for (int i = 0; i < dabs; ++i) {
        brush.dab(terrain, random_dab(grid, random, 200, 40, 300));
        refreshed.refresh(terrain);
    }
    render::Pyramid rebuilt(terrain);
    terrain.tiles.mark_all();
    rebuilt.refresh(terrain);
    return differing_bits(refreshed.highest.read_all<float>(), rebuilt.highest.read_all<float>()) +
           differing_bits(refreshed.lowest.read_all<float>(), rebuilt.lowest.read_all<float>());
}

KeptFrames kept_frames(const Grid& grid, const std::string& method, int frames, glm::ivec2 size) {
    const std::vector<float> heights = generate_heights(grid, {"mountains", 5, 1500});
    Shown kept(grid, heights);
    Shown fresh(grid, heights);
    std::mt19937 random(23);
    std::uniform_real_distribution<double> unit(0, 1);
    render::ViewSettings settings;
    settings.method = method;
    settings.sun = glm::normalize(glm::dvec3(-0.8, 0.5, 0.3));
    render::Camera camera = render::overview(grid, 0, 1500);
    const auto apply = [&](const Operation& operation) {
        kept.simulation.apply(operation);
        fresh.simulation.apply(operation);
    };
    KeptFrames found;
    for (; found.frames < frames; ++found.frames) {
        const double dice = unit(random);
        if (dice < 0.35) {
            apply(random_dab(grid, random, 330, 400, 1000));
        } else if (dice < 0.45) {
            apply(Ticks{1});
        } else if (dice < 0.6) {
            camera.eye = glm::dvec3(grid.width_m() * unit(random), grid.height_m() * unit(random),
                                    900 + 8000 * unit(random) * unit(random));
            camera.target = glm::dvec3(grid.width_m() * unit(random), grid.height_m() * unit(random), 600);
            // Some straight down, by parallel rays.
            camera.parallel_m = random() % 4 == 0 ? 500 + 15000 * unit(random) : 0;
            if (camera.is_parallel()) {
                camera.eye.z = 50000;
                camera.target = camera.eye - glm::dvec3(0, 0, 1);
            }
        } else if (dice < 0.65) {
            settings.sun =
                glm::normalize(glm::dvec3(unit(random) - 0.5, unit(random) - 0.5, 0.1 + 0.5 * unit(random)));
        } else if (dice < 0.7) {
            settings.view = render::views()[random() % render::views().size()].name;
        } else if (dice < 0.73) {
            settings.tolerance_px = random() % 3;
        }
        const render::Drawn drawn =
            kept.renderer.draw(kept.simulation.terrain(), camera, settings, size.x, size.y);
        fresh.renderer.forget();
        fresh.renderer.draw(fresh.simulation.terrain(), camera, settings, size.x, size.y);
        ++found.drawn[static_cast<std::size_t>(drawn)];
        const bool same =
            kept.renderer.read_depth(size.x, size.y) == fresh.renderer.read_depth(size.x, size.y) &&
            kept.renderer.read_rgb(size.x, size.y) == fresh.renderer.read_rgb(size.x, size.y);
        found.differing += same ? 0 : 1;
    }
    return found;
}

}  // namespace talus::claims
