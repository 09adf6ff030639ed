// The method clipmap is what its authors describe (Losasso & Hoppe 2004; Asirvatham & Hoppe 2005): each pixel
// shows the triangles of its ring, which go over into the coarser ring's; there are no cracks; and a ring
// that followed the eye is the ring made anew.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "render/cast_twin.h"
#include "render/measure.h"
#include "render/methods/method.h"
#include "render/survey.h"
#include "sim/gpu/context.h"
#include "sim/simulation.h"
#include "sim/simulation_parameters.h"
#include "sim/terrain/generate.h"
#include "tests/scenes/easel.h"
#include "tests/scenes/scenes.h"

namespace talus::clipmap_test {
namespace {

constexpr int width = 192;
constexpr int height = 108;
constexpr int side = 63;
constexpr int levels = 12;  // more than the farthest camera needs

render::OwnNumbers small_rings() {
    return {{"render.clipmap_samples", 0}, {"render.clipmap_levels", levels}};  // the first choice: 63
}

// The rings around an eye in double: their triangles' height anywhere.
class RingsTwin {
  public:
    explicit RingsTwin(const scenes::Scene& scene) : grid_(scene.grid) {
        patches_ = glm::ivec2(grid_.nx - 1, grid_.ny - 1);
        heights_.emplace_back(scene.heights.begin(), scene.heights.end());
        for (int level = 1; level < levels; ++level) {
            const glm::ivec2 last = last_of(level);
            std::vector<double> filtered;
            for (int y = 0; y <= last.y; ++y)
                for (int x = 0; x <= last.x; ++x) {
                    if ((x == 0 || x == last.x) && (y == 0 || y == last.y)) {
                        filtered.push_back(at(level - 1, {2 * x, 2 * y}));
                        continue;
                    }
                    double sum = 0;
                    for (int j = -1; j <= 1; ++j)
                        for (int i = -1; i <= 1; ++i)
                            sum += (i == 0 ? 0.5 : 0.25) * (j == 0 ? 0.5 : 0.25) *
                                   at(level - 1, {2 * x + i, 2 * y + j});
                    filtered.push_back(sum);
                }
            heights_.push_back(std::move(filtered));
        }
    }

    void look(const glm::dvec3& eye) { eye_ = {grid_.column_of(eye.x), grid_.row_of(eye.y)}; }

    // The least and the most of a level's triangles within so many samples of the terrain around a place.
    glm::dvec2 heights_near(int level, glm::dvec2 place, double reach) const {
        glm::dvec2 found(HUGE_VAL, -HUGE_VAL);
        for (const double v : {-reach, 0.0, reach})
            for (const double u : {-reach, 0.0, reach}) {
                const double z = height(level, place + glm::dvec2(u, v));
                found = {std::min(found.x, z), std::max(found.y, z)};
            }
        return found;
    }

  private:
    glm::ivec2 last_of(int level) const { return (patches_ + (1 << level) - 1) >> level; }

    double at(int level, glm::ivec2 sample) const {
        const glm::ivec2 last = last_of(level);
        const glm::ivec2 inside = glm::clamp(sample, glm::ivec2(0), last);
        return heights_[static_cast<std::size_t>(level)]
                       [static_cast<std::size_t>(inside.y) * (last.x + 1) + inside.x];
    }

    // Column or row of the terrain, of a sample of a level.
    double place_of(int level, int sample, int axis) const {
        return std::clamp(sample * (1 << level), 0, patches_[axis]);
    }

    // Of three samples' plane: corners of a square of a level around a place, split from north-east to
    // south-west.
    template <typename Height>
    double on_triangles(int level, glm::dvec2 place, const Height& of) const {
        glm::ivec2 low;
        glm::dvec2 share;
        for (int axis = 0; axis < 2; ++axis) {
            low[axis] =
                std::min(static_cast<int>(std::floor(place[axis] / (1 << level))), last_of(level)[axis] - 1);
            low[axis] = std::max(low[axis], 0);
            const double first = place_of(level, low[axis], axis);
            share[axis] = (place[axis] - first) / (place_of(level, low[axis] + 1, axis) - first);
        }
        const double north_east = of(low + glm::ivec2(1, 0));
        const double south_west = of(low + glm::ivec2(0, 1));
        if (share.x + share.y <= 1) {
            const double corner = of(low);
            return corner + share.x * (north_east - corner) + share.y * (south_west - corner);
        }
        const double corner = of(low + 1);
        return corner + (1 - share.x) * (south_west - corner) + (1 - share.y) * (north_east - corner);
    }

    // Of a sample of a ring, between its own height and the coarser triangles'.
    double of_sample(int level, glm::ivec2 sample) const {
        const double own = at(level, sample);
        if (level + 1 == levels) return own;
        const double transition = 0.1 * side;
        double share = 0;
        for (int axis = 0; axis < 2; ++axis)
            share = std::max(share, (std::abs(sample[axis] - eye_[axis] / (1 << level)) -
                                     (0.5 * (side - 1) - transition - 1)) /
                                        transition);
        share = std::clamp(share, 0.0, 1.0);
        const glm::dvec2 place(place_of(level, sample.x, 0), place_of(level, sample.y, 1));
        const double coarser =
            on_triangles(level + 1, place, [&](glm::ivec2 corner) { return at(level + 1, corner); });
        return own + share * (coarser - own);
    }

    double height(int level, glm::dvec2 place) const {
        return on_triangles(level, glm::clamp(place, glm::dvec2(0), glm::dvec2(patches_)),
                            [&](glm::ivec2 sample) { return of_sample(level, sample); });
    }

    Grid grid_;
    glm::ivec2 patches_{0};
    glm::dvec2 eye_{0};
    std::vector<std::vector<double>> heights_;
};

double ground_at(const scenes::Scene& scene, glm::dvec2 place) {
    const glm::ivec2 at(glm::floor(place));
    const glm::dvec2 in = place - glm::dvec2(at);
    const auto sample = [&](int x, int y) {
        return double(scene.heights[static_cast<std::size_t>(at.y + y) * scene.grid.nx + at.x + x]);
    };
    return (1 - in.y) * ((1 - in.x) * sample(0, 0) + in.x * sample(1, 0)) +
           in.y * ((1 - in.x) * sample(0, 1) + in.x * sample(1, 1));
}

// The place that a pixel shows lies on triangles of one of the rings, which the method names by three kinds
// in turn. What differs: the outlines, where odd samples lie on even ones. The wider the ring, the larger its
// error.
TEST(Clipmap, ShowsTheTrianglesOfItsRings) {
    const gpu::Context context;
    const render::Method clipmap = render::make_clipmap(render::Detail::kind);
    for (const std::string& name : scenes::names()) {
        const scenes::Scene scene = scenes::make(name);
        scenes::Easel easel(scene, width, height);
        RingsTwin twin(scene);
        const double relief = *std::max_element(scene.heights.begin(), scene.heights.end()) -
                              *std::min_element(scene.heights.begin(), scene.heights.end());
        std::array<long, levels> by_level{};
        std::array<double, levels> squares_m2{};  // of heights over the bilinear surface
        long compared = 0;
        long otherwise = 0;
        for (const render::NamedCamera& view : render::survey(scene.grid, scene.heights)) {
            twin.look(view.camera.eye);
            const render::CameraRays rays = render::camera_rays(view.camera, width, height);
            const std::vector<glm::vec2> drawn = easel.draw(clipmap, view.camera, 0, small_rings());
            for (int y = 0; y < height; ++y)
                for (int x = 0; x < width; ++x) {
                    const glm::vec2 shown = drawn[static_cast<std::size_t>(y) * width + x];
                    if (std::isinf(shown.x) || shown.x == 0) continue;  // sky, or the eye is in the ground
                    const glm::dvec3 ray =
                        glm::normalize(rays.middle + (2 * (x + 0.5) / width - 1) * rays.right +
                                       (2 * (y + 0.5) / height - 1) * rays.up);
                    const glm::dvec3 hit = view.camera.eye + double(shown.x) * ray;
                    const glm::dvec2 place(scene.grid.column_of(hit.x), scene.grid.row_of(hit.y));
                    const glm::dvec2 inside(scene.grid.nx - 1.01, scene.grid.ny - 1.01);
                    // The terrain's sides.
                    if (place.x < 0.01 || place.y < 0.01 || place.x > inside.x || place.y > inside.y)
                        continue;
                    ++compared;
                    // A vertex lies within 1/256 pixel, a distance is right to some millionths.
                    const double reach = 1e-5 * shown.x / std::min(scene.grid.dx, scene.grid.dy) + 1e-3;
                    bool found = false;
                    for (int level = shown.y == 1   ? 0
                                     : shown.y == 2 ? 1
                                                    : 2;
                         level < levels && !found; level += 3) {
                        const glm::dvec2 heights = twin.heights_near(level, place, reach);
                        const double room = 1e-5 * (shown.x + relief);
                        found = hit.z >= heights.x - room && hit.z <= heights.y + room;
                        if (!found) continue;
                        ++by_level[static_cast<std::size_t>(level)];
                        const double off_m = hit.z - ground_at(scene, place);
                        squares_m2[static_cast<std::size_t>(level)] += off_m * off_m;
                    }
                    otherwise += found ? 0 : 1;
                }
        }
        std::printf("%s: %ld pixels compared, %ld lie on no triangle of their level; by level", name.c_str(),
                    compared, otherwise);
        for (const long pixels : by_level) std::printf(" %ld", pixels);
        std::printf("; metres off, root of the mean square");
        std::vector<double> off_m;
        for (std::size_t level = 0; level < levels; ++level) {
            const auto pixels = static_cast<double>(by_level[level]);
            std::printf(" %.2f", pixels > 0 ? std::sqrt(squares_m2[level] / pixels) : 0.0);
            if (pixels > 1000) off_m.push_back(std::sqrt(squares_m2[level] / pixels));
        }
        std::printf("\n");
        EXPECT_GE(off_m.size(), 3U) << name;
        // Flat ground with needles has no error that grows.
        EXPECT_TRUE(name == "spikes" || std::is_sorted(off_m.begin(), off_m.end())) << name;
        EXPECT_GT(compared, 11 * width * height / 3) << name;
        EXPECT_LE(100 * otherwise, compared) << name;
        for (int level = 0; level < 4; ++level)
            EXPECT_GT(by_level[static_cast<std::size_t>(level)], 100) << name << ", level " << level;
    }
}

// Below the surface is nothing to be seen, since triangles have no back: through a crack one sees the sky.
// Eyes that look down on rough ground so that they see no horizon, and eyes from outside on the terrain's
// sides, which rings of several levels share: there, what lies lower than all ground. The smallest rings.
TEST(Clipmap, HasNoCracks) {
    const gpu::Context context;
    const render::Method clipmap = render::make_clipmap(render::Detail::none);
    std::mt19937 random(5);
    std::uniform_real_distribution<double> unit(0, 1);
    for (const Grid grid : {Grid{701, 645, 10, 10}, Grid{513, 513, 10, 10}, Grid{300, 411, 12, 8}}) {
        const scenes::Scene scene{grid, generate_heights(grid, {"mountains", 7, 900})};
        const double lowest = *std::min_element(scene.heights.begin(), scene.heights.end());
        scenes::Easel easel(scene, 2 * width, 2 * height);
        render::Measure measure(scene.grid, scene.heights);
        const glm::dvec2 size(grid.width_m(), grid.height_m());
        std::array<long, 2> pixels{};
        std::array<long, 2> cracks{};
        for (int i = 0; i < 200; ++i) {
            const double turn = 2 * std::numbers::pi * unit(random);
            const glm::dvec2 way(std::cos(turn), std::sin(turn));
            const std::size_t from_outside = i % 2;
            render::Camera camera;
            if (from_outside != 0) {
                camera.eye =
                    glm::dvec3(0.5 * size + way * (0.55 + 0.5 * unit(random)) * glm::length(size), 700);
                camera.target = glm::dvec3(0.5 * size + way * 0.4 * size, -300);
            } else {
                camera.eye = glm::dvec3(size * (0.3 + 0.4 * unit(random)), 950 + 300 * unit(random));
                camera.target = camera.eye + glm::dvec3(way, -1 - 2 * unit(random));
            }
            const std::vector<double> truth = measure.reference(camera, 2 * width, 2 * height);
            const auto is_sky = [](double distance_m) { return std::isinf(distance_m); };
            if (from_outside == 0 && std::any_of(truth.begin(), truth.end(), is_sky)) continue;
            const std::vector<glm::vec2> drawn = easel.draw(clipmap, camera, 0, small_rings());
            const render::CameraRays rays = render::camera_rays(camera, 2 * width, 2 * height);
            for (int y = 0; y < 2 * height; ++y)
                for (int x = 0; x < 2 * width; ++x) {
                    const std::size_t at = static_cast<std::size_t>(y) * 2 * width + x;
                    const glm::dvec3 ray = glm::normalize(rays.middle + ((x + 0.5) / width - 1) * rays.right +
                                                          ((y + 0.5) / height - 1) * rays.up);
                    // On the outline, snapped vertices may miss a pixel's middle.
                    if (is_sky(truth[at]) || (x > 0 && is_sky(truth[at - 1])) ||
                        (x + 1 < 2 * width && is_sky(truth[at + 1])))
                        continue;
                    if (from_outside != 0 && camera.eye.z + truth[at] * ray.z > lowest - 1) continue;
                    ++pixels[from_outside];
                    cracks[from_outside] += std::isinf(drawn[at].x) ? 1 : 0;
                }
        }
        std::printf("%d x %d: seen through: %ld of %ld pixels of the ground, %ld of %ld of the sides\n",
                    grid.nx, grid.ny, cracks[0], pixels[0], cracks[1], pixels[1]);
        for (std::size_t from_outside = 0; from_outside < 2; ++from_outside) {
            EXPECT_GT(pixels[from_outside], 20L * 4 * width * height);
            EXPECT_EQ(cracks[from_outside], 0);
        }
    }
}

// However few levels are asked for, the terrain is covered, from anywhere.
TEST(Clipmap, CoversTheTerrain) {
    const gpu::Context context;
    const scenes::Scene scene = scenes::make("fbm");
    scenes::Easel easel(scene, width, height);
    render::Measure measure(scene.grid, scene.heights);
    const render::Method clipmap = render::make_clipmap(render::Detail::none);
    for (const render::NamedCamera& view : render::survey(scene.grid, scene.heights)) {
        const std::vector<glm::vec2> drawn = easel.draw(
            clipmap, view.camera, 0, {{"render.clipmap_samples", 0}, {"render.clipmap_levels", 2}});
        const std::vector<double> truth = measure.reference(view.camera, width, height);
        long missing = 0;
        long hit = 0;
        for (std::size_t i = 0; i < truth.size(); ++i) {
            if (std::isinf(truth[i])) continue;
            ++hit;
            missing += std::isinf(drawn[i].x) ? 1 : 0;
        }
        // Crests are smoothed.
        EXPECT_LE(20 * missing, hit) << view.name;
    }
}

// An eye that walks, jumps and turns back while dabs fall: what the rings kept is what they would be anew.
TEST(Clipmap, RingsThatFollowAreRingsMadeAnew) {
    const gpu::Context context;
    const Grid grid{700, 513, 20, 15};
    Simulation simulation(bedrock_terrain(grid, generate_heights(grid, {"mountains", 4, 900})),
                          Parameters(simulation_parameters()));
    const Terrain& terrain = simulation.terrain();
    render::Pyramid pyramid(terrain);
    render::HitsTarget target(width, height);
    const render::Method kept = render::make_clipmap(render::Detail::kind);
    std::mt19937 random(8);
    std::uniform_real_distribution<double> unit(0, 1);
    glm::dvec3 eye(7000, 4000, 1200);
    const auto draw = [&](const render::Method& method, const render::Camera& camera) {
        // As few levels as the terrain allows: more are drawn where the eye is farther off.
        const render::OwnNumbers few = {{"render.clipmap_samples", 0}, {"render.clipmap_levels", 2}};
        method({terrain, pyramid, camera, width, height, 0, 16, target.framebuffer(), nullptr, few});
        return target.hits().read_all<glm::vec2>();
    };
    for (int frame = 0; frame < 60; ++frame) {
        const double step = frame % 10 == 9 ? 4000 : frame % 3 == 0 ? 3 : 150;
        eye += glm::dvec3(step * (unit(random) - 0.5), step * (unit(random) - 0.5), 0);
        // Low enough, in turn, that the finest rings are drawn.
        eye.z = frame % 2 == 0 ? 1200 : 700;
        if (frame % 4 == 1) {
            Dab dab;
            dab.effect = effect_of(BrushMode::raise);
            dab.x_m = eye.x + 1500 * (unit(random) - 0.5);
            dab.y_m = eye.y + 1500 * (unit(random) - 0.5);
            dab.radius_m = 300;
            dab.amount_m = 100;
            simulation.apply(dab);
        }
        pyramid.refresh(terrain);
        const render::Camera camera{eye, eye + glm::dvec3(0.4, 1, -0.6)};
        const std::vector<glm::vec2> drawn = draw(kept, camera);
        ASSERT_EQ(drawn, draw(render::make_clipmap(render::Detail::kind), camera)) << frame;
    }
}

}  // namespace
}  // namespace talus::clipmap_test
