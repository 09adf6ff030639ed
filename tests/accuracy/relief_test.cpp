// The method relief draws what its authors' search finds, and nothing else: its defects are those of samples
// that pass thin ground, and they shrink with the samples' spacing (Policarpo, Oliveira & Comba 2005).
#include <gtest/gtest.h>

#include <cmath>

#include "render/cast_twin.h"
#include "render/measure.h"
#include "render/methods/method.h"
#include "render/survey.h"
#include "sim/gpu/context.h"
#include "tests/scenes/easel.h"
#include "tests/scenes/scenes.h"

namespace talus::relief_test {
namespace {

constexpr int width = 192;
constexpr int height = 108;
constexpr int halvings = 20;

// Distances that the method draws.
std::vector<float> draw(scenes::Easel& easel, const render::Method& relief, const render::Camera& camera,
                        int samples) {
    return scenes::distances(easel.draw(
        relief, camera, 0, {{"render.relief_samples", samples}, {"render.relief_halvings", halvings}}));
}

// Every pixel against the same search in double: what differs is rounding, where a sample lies on the ground
// to its last digits.
TEST(Relief, DrawsWhatItsSearchFinds) {
    const gpu::Context context;
    const render::Method relief = render::make_relief(render::Detail::none);
    for (const std::string& name : scenes::names()) {
        const scenes::Scene scene = scenes::make(name);
        scenes::Easel easel(scene, width, height);
        maths::CastTwin<double> twin(scene.grid, scene.heights);
        long otherwise = 0;
        long pixels = 0;
        for (const render::NamedCamera& view : render::survey(scene.grid, scene.heights))
            for (const int samples : {16, 64, 300}) {
                const std::vector<float> drawn = draw(easel, relief, view.camera, samples);
                twin.look(scene.grid, view.camera, width, height);
                for (int y = 0; y < height; ++y)
                    for (int x = 0; x < width; ++x) {
                        const double found = twin.march_pixel(2 * (x + 0.5) / width - 1,
                                                              2 * (y + 0.5) / height - 1, samples, halvings)
                                                 .distance_m;
                        const double shown = drawn[static_cast<std::size_t>(y) * width + x];
                        ++pixels;
                        if (found < 0 ? std::isfinite(shown)
                                      : !(std::abs(shown - found) <= 1e-3 * std::max(found, 1e-3)))
                            ++otherwise;
                    }
            }
        std::printf("%s: %ld of %ld pixels differ from the search in double\n", name.c_str(), otherwise,
                    pixels);
        EXPECT_LE(static_cast<double>(otherwise), 1e-3 * static_cast<double>(pixels)) << name;
    }
}

// Sixteen times the samples: at most a quarter of the wrong pixels, and with 1024 fewer than one of a
// thousand, but for needles as thin as a sample. No pixel shows what lies nearer than the ground, because a
// sample under it is behind it.
TEST(Relief, ErrsLessWithMoreSamples) {
    const gpu::Context context;
    const render::Method relief = render::make_relief(render::Detail::none);
    for (const std::string& name : scenes::names()) {
        const scenes::Scene scene = scenes::make(name);
        scenes::Easel easel(scene, width, height);
        render::Measure measure(scene.grid, scene.heights);
        std::map<int, render::PictureError> errors;
        int nearer = 0;
        for (const render::NamedCamera& view : render::survey(scene.grid, scene.heights))
            for (const int samples : {64, 1024}) {
                const std::vector<float> drawn = draw(easel, relief, view.camera, samples);
                const std::vector<double> truth = measure.reference(view.camera, width, height);
                for (std::size_t i = 0; i < drawn.size(); ++i) nearer += drawn[i] < 0.999 * truth[i] ? 1 : 0;
                const render::PictureError error = measure.compare(view.camera, width, height, drawn, 0.5);
                errors[samples].beyond += error.beyond;
                errors[samples].pixels_hit += error.pixels_hit;
            }
        std::printf(
            "%s: of %d pixels that are hit, wrong by more than half a pixel %d with 64 samples, %d with "
            "1024\n",
            name.c_str(), errors[64].pixels_hit, errors[64].beyond, errors[1024].beyond);
        EXPECT_GT(errors[64].beyond, 0) << "nothing was missed: the comparison proves nothing";
        EXPECT_LE(4 * errors[1024].beyond, errors[64].beyond) << name;
        if (name != "spikes") {
            EXPECT_LE(1000 * errors[1024].beyond, errors[1024].pixels_hit) << name;
        }
        EXPECT_EQ(nearer, 0) << name;
    }
}

}  // namespace
}  // namespace talus::relief_test
