// A photo over the terrain, filtered along the view.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>

#include "render/renderer.h"
#include "sim/terrain/generate.h"
#include "tests/bench/measure.h"
#include "tests/bench/papers/table.h"
#include "tests/bench/papers/tables.h"
#include "tests/bench/papers/terrains.h"

namespace talus::bench {
namespace {

// A photo's kinds of detail: lines a few texels wide, and patches of colour of all sizes.
std::vector<std::uint8_t> made_photo(int side) {
    std::vector<std::uint8_t> rgba(static_cast<std::size_t>(side) * side * 4, 255);
    const Grid grid{side, side, 1, 1};
    const std::vector<float> fields = generate_heights(grid, {"hills", 9, 255});
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            const std::size_t i = static_cast<std::size_t>(y) * side + x;
            const bool line = x % 61 < 3 || y % 47 < 3;
            const auto grey = static_cast<std::uint8_t>(std::clamp(fields[i], 0.0F, 255.0F));
            rgba[4 * i] = line ? 235 : grey / 2;
            rgba[4 * i + 1] = line ? 230 : grey / 2 + (x / 16 + y / 16) % 2 * 60;
            rgba[4 * i + 2] = line ? 220 : grey / 3;
        }
    return rgba;
}

// The picture from `times` squared samples a pixel, whose light is averaged: bytes are roots of light.
std::vector<double> supersampled(const std::vector<std::uint8_t>& large, glm::ivec2 size, int times) {
    std::vector<double> light(static_cast<std::size_t>(size.x) * size.y * 3, 0);
    const int width = size.x * times;
    for (int y = 0; y < size.y * times; ++y)
        for (int x = 0; x < width; ++x)
            for (int c = 0; c < 3; ++c) {
                const double byte = large[3 * (static_cast<std::size_t>(y) * width + x) + c];
                light[3 * (static_cast<std::size_t>(y / times) * size.x + x / times) + c] += byte * byte;
            }
    for (double& sum : light) sum = std::sqrt(sum / (times * times));
    return light;
}

double rms(const std::vector<std::uint8_t>& shown, const std::vector<double>& reference) {
    double sum = 0;
    for (std::size_t i = 0; i < shown.size(); ++i)
        sum += (shown[i] - reference[i]) * (shown[i] - reference[i]);
    return std::sqrt(sum / static_cast<double>(shown.size()));
}

}  // namespace

// Dick et al. 2009, section 3.3: a photo over the terrain, filtered by so many taps along the view, against
// 64 samples a pixel.
void dick_footprint(const PaperRun& run) {
    Table table("dick_footprint", "pictures,taps,rms_of_255,colours_ms");
    constexpr int times = 8;
    const PaperTerrain paper = paper_terrain_of(2048);
    const Terrain terrain(bedrock_terrain(paper.grid, paper.heights));
    const std::vector<std::uint8_t> photo = made_photo(4096);
    render::Renderer renderer(terrain, run.patch_pixels);
    renderer.drape(4096, 4096, std::as_bytes(std::span(photo)));
    for (const bool walks : {false, true}) {
        const std::vector<int> taps = {1, 2, 4, 8, 16};
        std::vector<double> squares(taps.size(), 0);
        std::vector<double> ms(taps.size(), 0);
        const auto cameras = walks ? paper_walk(paper, 5) : paper_flight(paper, 5);
        for (const render::Camera& camera : cameras) {
            std::vector<render::ViewSettings> settings(taps.size());
            for (std::size_t i = 0; i < taps.size(); ++i) {
                settings[i].method = "exact";
                settings[i].shadows = false;
                settings[i].numbers = {{"render.texture_taps", taps[i]}};
            }
            const glm::ivec2 large = times * small_picture;
            renderer.draw(terrain, camera, settings.back(), large.x, large.y);
            const std::vector<double> reference =
                supersampled(renderer.read_rgb(large.x, large.y), small_picture, times);
            std::vector<Contestant> contestants;
            for (std::size_t i = 0; i < taps.size(); ++i) {
                // After the first one the rays are kept: only colours are drawn.
                const auto draw = [&renderer, &terrain, &camera, &settings, i] {
                    renderer.draw(terrain, camera, settings[i], small_picture.x, small_picture.y);
                    return renderer.read_rgb(small_picture.x, small_picture.y);
                };
                const double error = rms(draw(), reference);
                squares[i] += error * error;
                contestants.push_back({"", [draw] { const auto wait = draw(); }});
            }
            const std::vector<double> seconds = interleave(contestants, 7);
            for (std::size_t i = 0; i < taps.size(); ++i) ms[i] += 1e3 * seconds[i];
        }
        const auto count = static_cast<double>(cameras.size());
        for (std::size_t i = 0; i < taps.size(); ++i)
            table.row(fmt::format("{},{},{:.2f},{:.2f}", walks ? "walk" : "fly", taps[i],
                                  std::sqrt(squares[i] / count), ms[i] / count));
    }
}

}  // namespace talus::bench
