// What stands around a terrain that was cut out of one in tiles: both together are the picture of the whole.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <random>

#include "render/renderer.h"
#include "render/tiled/tiled_renderer.h"
#include "sim/gpu/context.h"
#include "sim/terrain/generate.h"
#include "tests/scenes/load_tiles.h"

namespace talus::backdrop_test {
namespace {

constexpr glm::ivec2 size(480, 270);
constexpr glm::ivec2 first(200, 130);  // of the cut-out, among the whole's samples
constexpr glm::ivec2 count(180, 150);
constexpr int tile_side = 256;
constexpr Grid whole_grid{641, 513, 20, 25};
constexpr Grid cut_grid{count.x, count.y, 20, 25};

// With a needle in the cut-out that stays the highest sample of all: rays begin to count below that, and
// colours go by it.
std::vector<float> mountains() {
    std::vector<float> heights = generate_heights(whole_grid, {"mountains", 5, 1500});
    heights[static_cast<std::size_t>(first.y + 140) * whole_grid.nx + first.x + 170] = 6000;
    return heights;
}

std::vector<float> cut_out_of(const std::vector<float>& whole) {
    std::vector<float> heights;
    for (int y = 0; y < count.y; ++y)
        for (int x = 0; x < count.x; ++x)
            heights.push_back(whole[static_cast<std::size_t>(first.y + y) * whole_grid.nx + first.x + x]);
    return heights;
}

// Raises the samples of a rectangle of the whole.
void raise(std::vector<float>& heights, glm::ivec2 from, glm::ivec2 to, float by_m) {
    for (int y = from.y; y < to.y; ++y)
        for (int x = from.x; x < to.x; ++x) heights[static_cast<std::size_t>(y) * whole_grid.nx + x] += by_m;
}

glm::dvec3 over_tiles(glm::dvec3 over_cut_out) {
    return over_cut_out + glm::dvec3(first.x * 20.0, (whole_grid.ny - first.y - count.y) * 25.0, 0);
}

// In the cut-out's metres: high over it, from outside into it, from within out of it, along the ground,
// straight down, and so by parallel rays.
std::vector<render::Camera> cameras() {
    return {{{1700, -4000, 4500}, {1800, 1900, 900}},
            {{-2500, 1500, 2200}, {1800, 1800, 900}},
            {{1800, 1900, 750}, {6000, 4500, -100}},
            {{1500, 1700, 650}, {-2000, -2500, 200}},
            {{1800, 1900, 5000}, {1800, 1900.1, 0}},
            {{1800, 1900, 5000}, {1800, 1900, 0}, 50, {0, 0}, {1, 1}, 6000}};
}

render::ViewSettings settings_of(double tolerance_px, const std::string& view = "shaded") {
    render::ViewSettings settings;
    settings.method = "exact";
    settings.view = view;
    settings.tolerance_px = tolerance_px;
    settings.sun = glm::normalize(glm::dvec3(-0.7, 0.6, 0.35));
    return settings;
}

struct Picture {
    std::vector<std::uint8_t> rgb;
    std::vector<float> depth;
};

// The whole in tiles.
class Whole {
  public:
    explicit Whole(const std::vector<float>& heights)
        : tiles(whole_grid, heights, tile_side), surface(tiles.tree(), tiles.bounds(), 32) {
        scenes::put_coarsest(surface, tiles);
    }
    Picture draw(render::Camera camera, const render::ViewSettings& settings) {
        camera.eye = over_tiles(camera.eye);
        camera.target = over_tiles(camera.target);
        scenes::load_tiles(surface, tiles, camera, size, settings.tolerance_px);
        renderer_.draw(surface, camera, settings, size.x, size.y);
        return {renderer_.read_rgb(size.x, size.y), renderer_.read_depth(size.x, size.y)};
    }

    scenes::MemoryTiles tiles;
    render::TiledSurface surface;

  private:
    render::TiledRenderer renderer_;
};

// A cut-out before the rest of the whole.
class CutOut {
  public:
    CutOut(const std::vector<float>& heights, Whole& around)
        : terrain(bedrock_terrain(cut_grid, heights)),
          around_(around),
          backdrop(around.surface, cut_grid, first),
          renderer(terrain, 8) {
        renderer.stand_before(&backdrop);
    }
    Picture draw(const render::Camera& camera, const render::ViewSettings& settings) {
        scenes::load_tiles(around_.surface, around_.tiles, backdrop.camera_over_tiles(camera), size,
                           settings.tolerance_px);
        backdrop.note_change();
        return draw_again(camera, settings);
    }
    // Without a look at the tiles.
    Picture draw_again(const render::Camera& camera, const render::ViewSettings& settings) {
        renderer.draw(terrain, camera, settings, size.x, size.y);
        return {renderer.read_rgb(size.x, size.y), renderer.read_depth(size.x, size.y)};
    }

    Terrain terrain;

  private:
    Whole& around_;

  public:
    render::Backdrop backdrop;
    render::Renderer renderer;
};

// Pixels whose colours differ, of those that show ground at least so many samples from the cut-out's edges,
// and from edges of tiles, whose slopes look at samples of theirs alone.
std::size_t different_beside_the_edge(const render::Camera& camera, const Picture& a, const Picture& b,
                                      double samples) {
    const render::CameraRays rays = render::camera_rays(camera, size.x, size.y);
    std::size_t differ = 0;
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x) {
            const std::size_t at = static_cast<std::size_t>(y) * size.x + x;
            const glm::dvec2 place(2 * (x + 0.5) / size.x - 1, 1 - 2 * (y + 0.5) / size.y);
            const glm::dvec3 point =
                camera.eye + rays.start + place.x * rays.start_right + place.y * rays.start_up +
                static_cast<double>(a.depth[at]) *
                    glm::normalize(rays.middle + place.x * rays.right + place.y * rays.up);
            const glm::dvec2 column_row(cut_grid.column_of(point.x), cut_grid.row_of(point.y));
            const glm::dvec2 from_first = glm::abs(column_row);
            const glm::dvec2 from_last = glm::abs(column_row - glm::dvec2(count - 1));
            const glm::dvec2 in_tiles = (column_row + glm::dvec2(first)) / double{tile_side};
            const glm::dvec2 from_tile = double{tile_side} * glm::abs(in_tiles - glm::round(in_tiles));
            const glm::dvec2 nearest = glm::min(glm::min(from_first, from_last), from_tile);
            const bool near = std::min(nearest.x, nearest.y) < samples;
            if (!near && !std::equal(a.rgb.begin() + static_cast<std::ptrdiff_t>(3 * at),
                                     a.rgb.begin() + static_cast<std::ptrdiff_t>(3 * at + 3),
                                     b.rgb.begin() + static_cast<std::ptrdiff_t>(3 * at)))
                ++differ;
        }
    return differ;
}

// Colours look at samples so far away (render/renderer.cpp).
constexpr double normals_reach = 14;

class Backdrops : public ::testing::Test {
  protected:
    gpu::Context context;
};

// Law 2: where all is of the finest level, nobody sees that a part is drawn in another way.
TEST_F(Backdrops, AreTheRestOfTheWhole) {
    const std::vector<float> heights = mountains();
    Whole whole(heights);
    CutOut cut_out(cut_out_of(heights), whole);
    for (const char* const view : {"shaded", "hillshade", "slope", "contours", "bands"})
        for (const render::Camera& camera : cameras()) {
            const render::ViewSettings settings = settings_of(0, view);
            const Picture together = cut_out.draw(camera, settings);
            const Picture alone = whole.draw(camera, settings);
            ASSERT_EQ(together.depth, alone.depth) << view << " from " << camera.eye.x;
            // Slopes beside an edge of a tile, edges of shadows, and lines fall to the other side of a
            // rounding.
            EXPECT_LE(different_beside_the_edge(camera, together, alone, normals_reach), 40U)
                << view << " from " << camera.eye.x;
        }
}

// A tower in the cut-out and one beside it: each one's shadow goes over the edge.
TEST_F(Backdrops, ThrowShadowsOnTheCutOutAndTakeItsOwn) {
    std::vector<float> before = mountains();
    raise(before, {first.x - 30, first.y + 60}, {first.x - 25, first.y + 80}, 900);
    std::vector<float> after = before;
    raise(after, first + glm::ivec2(20, 20), first + glm::ivec2(40, 26), 1200);
    Whole around(before);
    Whole whole(after);
    CutOut cut_out(cut_out_of(after), around);
    CutOut unraised(cut_out_of(before), around);
    std::size_t shaded_around = 0;
    for (const glm::dvec2 side :
         {glm::dvec2(1, 0.1), glm::dvec2(-1, 0.2), glm::dvec2(0.1, 1), glm::dvec2(0.2, -1)})
        for (const render::Camera& camera : cameras()) {
            render::ViewSettings settings = settings_of(0);
            settings.sun = glm::normalize(glm::dvec3(side, 0.3));
            const Picture together = cut_out.draw(camera, settings);
            const Picture alone = whole.draw(camera, settings);
            ASSERT_EQ(together.depth, alone.depth);
            // A shadow's edge may fall to the other side of a pixel: its rays start and end elsewhere.
            EXPECT_LE(different_beside_the_edge(camera, together, alone, normals_reach), 40U) << camera.eye.x;
            const Picture low = unraised.draw(camera, settings);
            for (std::size_t i = 0; i < low.depth.size(); ++i)
                shaded_around +=
                    low.depth[i] == together.depth[i] && low.rgb[3 * i] > together.rgb[3 * i] + 20 ? 1 : 0;
        }
    EXPECT_GT(shaded_around, 1000U);
}

// Work that reaches the edge leaves walls there, and nobody sees through.
TEST_F(Backdrops, LeaveNoHoleWhereWorkReachesTheEdge) {
    const std::vector<float> heights = mountains();
    Whole whole(heights);
    std::vector<float> dug = heights;
    raise(dug, first - 2, first + glm::ivec2(count.x + 2, 60), -300);
    raise(dug, first + glm::ivec2(-2, 60), first + count + 2, 150);
    CutOut cut_out(cut_out_of(dug), whole);
    for (const double tolerance_px : {0.0, 2.0})
        for (const render::Camera& camera : cameras()) {
            const Picture together = cut_out.draw(camera, settings_of(tolerance_px));
            const Picture alone = whole.draw(camera, settings_of(tolerance_px));
            std::size_t lost = 0;
            std::size_t moved = 0;
            for (std::size_t i = 0; i < alone.depth.size(); ++i) {
                lost += std::isfinite(alone.depth[i]) && !std::isfinite(together.depth[i]) ? 1 : 0;
                moved += together.depth[i] != alone.depth[i] ? 1 : 0;
            }
            // On the skyline alone, where what was dug away stood before the sky.
            EXPECT_LT(lost, 400U) << camera.eye.x;
            EXPECT_GT(moved, 2000U) << camera.eye.x;
        }
}

// Pixels whose colours differ, of those that show ground beyond the cut-out.
std::size_t moved_on_tiles(const render::Camera& camera, const std::vector<float>& depth,
                           const std::vector<std::uint8_t>& a, const std::vector<std::uint8_t>& b) {
    const render::CameraRays rays = render::camera_rays(camera, size.x, size.y);
    std::size_t moved = 0;
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x) {
            const std::size_t i = static_cast<std::size_t>(y) * size.x + x;
            if (!std::isfinite(depth[i])) continue;
            const glm::dvec3 ray = glm::normalize(rays.middle + (2 * (x + 0.5) / size.x - 1) * rays.right +
                                                  (1 - 2 * (y + 0.5) / size.y) * rays.up);
            const glm::dvec3 at = camera.eye + rays.start + (2 * (x + 0.5) / size.x - 1) * rays.start_right +
                                  (1 - 2 * (y + 0.5) / size.y) * rays.start_up +
                                  static_cast<double>(depth[i]) * ray;
            const bool beyond = at.x < -100 || at.y < -100 || at.x > cut_grid.width_m() + 100 ||
                                at.y > cut_grid.height_m() + 100;
            moved += beyond && (a[3 * i] != b[3 * i] || a[3 * i + 1] != b[3 * i + 1]) ? 1 : 0;
        }
    return moved;
}

// What is kept from the picture before is what a fresh one has, bit for bit.
TEST_F(Backdrops, KeepNothingThatChanged) {
    const std::vector<float> heights = mountains();
    Whole whole(heights);
    CutOut kept(cut_out_of(heights), whole);
    std::mt19937 random(11);
    const auto any = [&](int below) { return static_cast<int>(random() % static_cast<unsigned>(below)); };
    render::Camera camera = cameras().front();
    render::ViewSettings settings = settings_of(0.5);
    std::vector<float> cut = cut_out_of(heights);
    int on_ground_alone = 0;
    std::vector<std::uint8_t> before;
    int shadows_moved = 0;
    for (int step = 0; step < 60; ++step) {
        // Finer tiles may come in the frame in which the ground changes.
        const bool together = any(3) == 0;
        if (together) {
            whole.surface.clear();
            whole.surface.look(kept.backdrop.camera_over_tiles(camera), size, settings.tolerance_px);
            kept.backdrop.note_change();
            kept.draw_again(camera, settings);
        }
        // A change of the ground alone: the backdrop's rays stay, and what the terrain's shadow does not
        // reach.
        bool of_ground_alone = false;
        switch (together ? 5 : any(12)) {
            case 0:
                camera = cameras()[static_cast<std::size_t>(any(5))];
                break;
            case 1:
                settings.sun = glm::normalize(glm::dvec3(any(9) - 4, any(9) - 4.5, 1 + any(4)));
                break;
            case 2:
                settings.view = any(2) == 0 ? "shaded" : "slope";
                break;
            case 3:
                settings.shadows = !settings.shadows;
                break;
            case 4:
                whole.surface.clear();
                break;
            default: {
                // Near the edge half the time, where its shadow leaves the terrain.
                const glm::ivec2 at(any(count.x - 10), any(2) == 0 ? any(count.y - 10) : count.y - 10);
                const gpu::Region region{at.x, at.y, 10, 10};
                std::vector<glm::vec4> texels;
                for (int y = at.y; y < at.y + 10; ++y)
                    for (int x = at.x; x < at.x + 10; ++x) {
                        float& height = cut[static_cast<std::size_t>(y) * count.x + x];
                        height += any(3) == 0 ? -150.0F : 200.0F;
                        texels.emplace_back(height, 0, 0, 0);
                    }
                kept.terrain.solid.front.write(region, std::as_bytes(std::span(texels)));
                kept.terrain.refresh(region);
                of_ground_alone = !together && step > 0;
                break;
            }
        }
        const Picture one = of_ground_alone ? kept.draw_again(camera, settings) : kept.draw(camera, settings);
        if (of_ground_alone) {
            ++on_ground_alone;
            // Colours of pixels that show the rest of the whole.
            const std::vector<float> nearest = kept.renderer.read_depth(size.x, size.y);
            const std::size_t moved = moved_on_tiles(camera, nearest, before, one.rgb);
            shadows_moved += moved > 0 ? 1 : 0;
        }
        EXPECT_EQ(kept.draw_again(camera, settings).rgb, one.rgb);
        before = one.rgb;
        // A sample of the refinement leaves what is kept alone.
        if (any(2) == 0) kept.renderer.refine(kept.terrain, 4);
        CutOut fresh(cut, whole);
        const Picture other = fresh.draw(camera, settings);
        ASSERT_EQ(one.rgb, other.rgb) << step;
        ASSERT_EQ(one.depth, other.depth) << step;
    }
    std::printf("ground changed alone %d times, its shadow on the rest %d times\n", on_ground_alone,
                shadows_moved);
    EXPECT_GE(on_ground_alone, 5);
    EXPECT_GE(shadows_moved, 3);
}

}  // namespace
}  // namespace talus::backdrop_test
