// The method ammann is what its authors describe (Ammann, Génevaux & Dischler 2010): where it draws a mesh,
// the full mesh's pixels; where it sends rays, what their search finds in the cells' boxes; and a change
// costs the cells that it touches.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "render/cast_twin.h"
#include "render/measure.h"
#include "render/methods/method.h"
#include "render/overview.h"
#include "render/survey.h"
#include "shaders/maths/twin.h"
#include "sim/gpu/context.h"
#include "sim/simulation.h"
#include "sim/simulation_parameters.h"
#include "sim/terrain/generate.h"
#include "tests/scenes/easel.h"
#include "tests/scenes/scenes.h"

namespace talus::ammann_test {
namespace {

using maths::max;
using maths::min;

constexpr int width = 192;
constexpr int height = 108;
// No cell has samples so large; those that reach behind the eye are mesh all the same.
constexpr double never_px = 1e6;

// The same triangles in another order: all pixels but single ones where two triangles, one of them seen on
// edge, have the same depth.
TEST(Ammann, OfMeshAloneIsTheMesh) {
    const gpu::Context context;
    const render::Method ammann = render::make_ammann(render::Detail::none);
    const render::Method mesh = render::make_mesh(render::Detail::none);
    for (const std::string& name : scenes::names()) {
        const scenes::Scene scene = scenes::make(name);
        scenes::Easel easel(scene, width, height);
        long pixels = 0;
        long otherwise = 0;
        int turn = 0;
        for (const render::NamedCamera& view : render::survey(scene.grid, scene.heights)) {
            const int cell = std::array<int, 3>{16, 75, 512}[static_cast<std::size_t>(turn++ % 3)];
            const std::vector<float> expected = scenes::distances(easel.draw(mesh, view.camera, 0));
            const std::vector<float> drawn = scenes::distances(
                easel.draw(ammann, view.camera, 0,
                           {{"render.ammann_cell_samples", cell}, {"render.ammann_mesh_from_px2", 0}}));
            pixels += static_cast<long>(drawn.size());
            for (std::size_t i = 0; i < drawn.size(); ++i) otherwise += drawn[i] != expected[i] ? 1 : 0;
        }
        std::printf("%s: %ld of %ld pixels are not the full mesh's\n", name.c_str(), otherwise, pixels);
        EXPECT_LE(otherwise, pixels / 100000) << name;
    }
}

struct PrecisionTwin {
    TALUS_TWIN_NAMES(double)
#include "maths/cell_precision.glsl"
};

// The cells of a terrain, their boxes, and what marching through all of them shows, in double.
class CellsTwin : PrecisionTwin {
  public:
    CellsTwin(const scenes::Scene& scene, int cell_patches, double range)
        : twin_(scene.grid, scene.heights), grid_(scene.grid), range_(range) {
        const int2 patches = twin_.patches;
        relief_m_ = real2(HUGE_VAL, -HUGE_VAL);
        for (int y = 0; y < patches.y; y += cell_patches)
            for (int x = 0; x < patches.x; x += cell_patches) {
                Cell cell{int2(x, y), glm::min(int2(x, y) + cell_patches, patches),
                          real2(HUGE_VAL, -HUGE_VAL), 0, false};
                for (int row = cell.first.y; row <= cell.last.y; ++row)
                    for (int column = cell.first.x; column <= cell.last.x; ++column) {
                        const double z =
                            scene.heights[static_cast<std::size_t>(row) * scene.grid.nx + column];
                        cell.bounds_m = real2(std::min(cell.bounds_m.x, z), std::max(cell.bounds_m.y, z));
                    }
                relief_m_ =
                    real2(std::min(relief_m_.x, cell.bounds_m.x), std::max(relief_m_.y, cell.bounds_m.y));
                cells_.push_back(cell);
            }
    }

    void look(const render::Camera& camera, int levels) {
        twin_.look(grid_, camera, width, height);
        origin_ = render::cast_origin(grid_, camera.eye);
        const double relief = relief_m_.y - relief_m_.x;
        const double diagonal = std::hypot(grid_.width_m(), grid_.height_m(), relief);
        for (Cell& cell : cells_) {
            const real2 middle = 0.5 * real2(cell.first + cell.last);
            const real3 centre((middle.x - origin_.cell.x - origin_.fraction.x) * grid_.dx,
                               -(middle.y - origin_.cell.y - origin_.fraction.y) * grid_.dy,
                               0.5 * (cell.bounds_m.x + cell.bounds_m.y) - origin_.height_m);
            const double share = relief > 0 ? (cell.bounds_m.y - cell.bounds_m.x) / relief : 0;
            cell.level = precision_level(cell_precision(centre, share, range_ * diagonal), levels);
            const real3 half(0.5 * (cell.last.x - cell.first.x) * grid_.dx,
                             0.5 * (cell.last.y - cell.first.y) * grid_.dy,
                             0.5 * (cell.bounds_m.y - cell.bounds_m.x));
            const real3 axis = twin_.ray_forward;
            cell.is_mesh = glm::dot(centre, axis) - glm::dot(half, glm::abs(axis)) <= 0;
        }
    }

    // The nearest hit of a pixel's ray in cells before the eye, and the level of precision of its cell;
    // infinity: none.
    std::pair<double, int> nearest(int x, int y, const std::vector<glm::ivec2>& steps) {
        const real3 ray = twin_.pixel_ray(real2(2 * (x + 0.5) / width - 1, 2 * (y + 0.5) / height - 1));
        std::pair<double, int> found{HUGE_VAL, -1};
        for (const Cell& cell : cells_) {
            if (cell.is_mesh) continue;
            const glm::ivec2 step = steps[static_cast<std::size_t>(cell.level)];
            const auto hit = twin_.march_box(cell.first, cell.last, cell.bounds_m - double(origin_.height_m),
                                             origin_.cell, real2(origin_.fraction), ray, step.x, step.y);
            if (hit.distance_m >= 0 && hit.distance_m < found.first) found = {hit.distance_m, cell.level};
        }
        return found;
    }

  private:
    struct Cell {
        int2 first;
        int2 last;
        real2 bounds_m;
        int level;
        bool is_mesh;  // it reaches behind the eye
    };
    maths::CastTwin<double> twin_;
    Grid grid_;
    double range_;
    render::CastOrigin origin_{};
    real2 relief_m_{0};
    std::vector<Cell> cells_;
};

// Every pixel that rays drew, against the same search in double through all boxes. What differs is rounding,
// where a sample lies on the ground to its last digits, and cells between two levels; and single pixels of a
// box's outline, because corners snap to parts of a pixel.
TEST(Ammann, DrawsWhatItsSearchFindsInTheBoxes) {
    const gpu::Context context;
    const render::Method ammann = render::make_ammann(render::Detail::kind);
    constexpr double range = 0.7;
    const std::vector<glm::ivec2> four = {{55, 25}, {32, 15}, {16, 10}, {8, 5}};
    const std::vector<render::PixelKind> kinds = render::ammann_kinds({});
    for (const std::string& name : scenes::names()) {
        const scenes::Scene scene = scenes::make(name);
        scenes::Easel easel(scene, width, height);
        CellsTwin twin(scene, 64, range);
        long compared = 0;
        long otherwise = 0;
        long other_level = 0;
        std::array<long, 4> by_level{};
        for (const render::NamedCamera& view : render::survey(scene.grid, scene.heights)) {
            const std::vector<glm::vec2> drawn = easel.draw(ammann, view.camera, 0,
                                                            {{"render.ammann_cell_samples", 64},
                                                             {"render.ammann_mesh_from_px2", never_px},
                                                             {"render.ammann_range", range}});
            twin.look(view.camera, 4);
            for (int y = 0; y < height; ++y)
                for (int x = 0; x < width; ++x) {
                    const glm::vec2 shown = drawn[static_cast<std::size_t>(y) * width + x];
                    if (shown.y == 1) continue;  // by mesh, or the terrain's side
                    const auto [distance_m, level] = twin.nearest(x, y, four);
                    ++compared;
                    const bool agrees = std::isinf(distance_m)
                                            ? std::isinf(shown.x)
                                            : std::abs(shown.x - distance_m) <= 1e-3 * distance_m;
                    otherwise += agrees ? 0 : 1;
                    if (!agrees || std::isinf(distance_m)) continue;
                    other_level +=
                        shown.y == static_cast<float>(kinds[1 + static_cast<std::size_t>(level)].kind) ? 0
                                                                                                       : 1;
                    ++by_level[static_cast<std::size_t>(level)];
                }
        }
        std::printf(
            "%s: %ld pixels compared, %ld differ from the search in double, %ld have another level; by level "
            "%ld, %ld, %ld, %ld\n",
            name.c_str(), compared, otherwise, other_level, by_level[0], by_level[1], by_level[2],
            by_level[3]);
        EXPECT_GT(compared, 12 * width * height / 2) << name;
        EXPECT_LE(1000 * otherwise, compared) << name;
        EXPECT_LE(1000 * other_level, compared) << name;
        for (const long pixels : by_level) EXPECT_GT(pixels, 1000) << name << ": a level was not tested";
    }
}

// Cracks: pixels that show what lies behind, where the full mesh shows ground and the search in double finds
// it in the boxes too. They come where cells of mesh, whose vertices the rasteriser snaps, meet cells of
// rays.
TEST(Ammann, HasFewCracks) {
    const gpu::Context context;
    const std::vector<glm::ivec2> most_precise = {{64, 25}};
    const render::Method ammann = render::make_ammann_of(most_precise, false);
    for (const std::string& name : scenes::names()) {
        const scenes::Scene scene = scenes::make(name);
        scenes::Easel easel(scene, width, height);
        const render::Method mesh = render::make_mesh(render::Detail::none);
        CellsTwin twin(scene, 32, 1);
        const double spacing_m = std::hypot(scene.grid.dx, scene.grid.dy);
        long cracks = 0;
        long pixels = 0;
        long mesh_cells = 0;
        for (const render::NamedCamera& view : render::survey(scene.grid, scene.heights)) {
            const std::vector<float> shown = scenes::distances(
                easel.draw(ammann, view.camera, 0,
                           {{"render.ammann_cell_samples", 32}, {"render.ammann_mesh_from_px2", 0.3}}));
            mesh_cells += ammann.figures().mesh_cells;
            const std::vector<float> by_mesh = scenes::distances(easel.draw(mesh, view.camera, 0));
            twin.look(view.camera, 1);
            for (int y = 0; y < height; ++y)
                for (int x = 0; x < width; ++x) {
                    const std::size_t i = static_cast<std::size_t>(y) * width + x;
                    if (std::isinf(by_mesh[i])) continue;
                    ++pixels;
                    // The search is slow: only where something is wrong.
                    if (shown[i] > by_mesh[i] + 4 * spacing_m)
                        cracks += shown[i] > twin.nearest(x, y, most_precise).first + 4 * spacing_m ? 1 : 0;
                }
        }
        std::printf("%s: %ld cracks in %ld pixels of ground, %ld cells of mesh\n", name.c_str(), cracks,
                    pixels, mesh_cells);
        EXPECT_GT(mesh_cells, 100) << name << ": nothing to crack";
        EXPECT_LE(10000 * cracks, pixels) << name;
    }
}

// Its rays' defects, and how they shrink: a larger k takes more samples, and so misses less (figure 7). A
// pixel is missed that shows what lies behind the ground, or the sky. Needles as thin as a sample are missed
// by most samples that there are.
TEST(Ammann, MissesLessWithMorePrecision) {
    const gpu::Context context;
    const render::Method ammann = render::make_ammann(render::Detail::kind);
    for (const std::string& name : scenes::names()) {
        const scenes::Scene scene = scenes::make(name);
        scenes::Easel easel(scene, width, height);
        render::Measure measure(scene.grid, scene.heights);
        std::map<double, int> missed;
        int by_rays = 0;
        for (const render::NamedCamera& view : render::survey(scene.grid, scene.heights)) {
            const std::vector<double> truth = measure.reference(view.camera, width, height);
            for (const double range : {0.1, 1000.0}) {
                const std::vector<glm::vec2> drawn =
                    easel.draw(ammann, view.camera, 0,
                               {{"render.ammann_range", range}, {"render.ammann_mesh_from_px2", never_px}});
                for (std::size_t i = 0; i < truth.size(); ++i) {
                    if (drawn[i].y == 1) continue;
                    by_rays += range > 1 ? 1 : 0;
                    missed[range] += drawn[i].x > 1.01 * truth[i] ? 1 : 0;
                }
            }
        }
        std::printf("%s: of %d pixels, missed %d at k 0.1, %d at 1000\n", name.c_str(), by_rays, missed[0.1],
                    missed[1000.0]);
        EXPECT_LT((name == "spikes" ? 1 : 2) * missed[1000.0], missed[0.1]) << name;
    }
}

TEST(Ammann, DrawsTheSameByListsOfTheHost) {
    const gpu::Context context;
    const scenes::Scene scene = scenes::make("fbm");
    scenes::Easel easel(scene, width, height);
    const std::vector<std::vector<glm::ivec2>> ladders = {{{64, 25}}, {{55, 25}, {16, 10}, {8, 5}}};
    for (const auto& steps : ladders) {
        const render::Method on_device = render::make_ammann_of(steps, false);
        const render::Method on_host = render::make_ammann_of(steps, true);
        for (const render::NamedCamera& view : render::survey(scene.grid, scene.heights)) {
            const render::OwnNumbers numbers = {{"render.ammann_cell_samples", 32}};
            EXPECT_EQ(easel.draw(on_device, view.camera, 0, numbers),
                      easel.draw(on_host, view.camera, 0, numbers))
                << view.name << ", " << steps.size() << " levels";
        }
    }
}

// Values of L by hand, from the authors' formula: 0 most exact, 1 least.
TEST(Ammann, TakesLessPrecisionFarOffAndForFlatCells) {
    const PrecisionTwin::real3 ahead(3000, 0, 0);
    EXPECT_DOUBLE_EQ(PrecisionTwin().cell_precision(ahead, 0.5, 4000), 0.75);
    EXPECT_DOUBLE_EQ(PrecisionTwin().cell_precision(2.0 * ahead, 0.5, 4000), 1);
    EXPECT_DOUBLE_EQ(PrecisionTwin().cell_precision({0, 0, -3000}, 0.5, 4000), 0.25);
    EXPECT_DOUBLE_EQ(PrecisionTwin().cell_precision({0, 0, -3000}, 1, 4000), 0);
    EXPECT_DOUBLE_EQ(PrecisionTwin().cell_precision({0, 2400, -1800}, 0.5, 4000), 0.75 - 0.5 * 0.6);
    EXPECT_EQ(PrecisionTwin().precision_level(0, 4), 0);
    EXPECT_EQ(PrecisionTwin().precision_level(0.74, 4), 2);
    EXPECT_EQ(PrecisionTwin().precision_level(0.76, 4), 3);
    EXPECT_EQ(PrecisionTwin().precision_level(1, 4), 3);
}

// Cells where a sample covers more than T pixels are mesh: A is the rectangle around the box's corners, also
// where it reaches beyond the picture, over the samples of the cell.
TEST(Ammann, IsMeshWhereSamplesCoverMorePixelsThanT) {
    const gpu::Context context;
    const Grid grid{513, 513, 10, 10};
    // Flat, so that a cell's box is its square.
    const scenes::Scene scene{grid, std::vector<float>(grid.count(), 0.0F)};
    scenes::Easel easel(scene, width, height);
    const render::Method ammann = render::make_ammann(render::Detail::kind);
    constexpr int cell = 64;
    render::Camera camera;
    camera.eye = {2560, 2560, 900};
    camera.target = {2560, 3560, 100};
    const render::CameraRays rays = render::camera_rays(camera, width, height);
    const auto place_px = [&](glm::dvec3 point) {
        const glm::dvec3 from_eye = point - camera.eye;
        const double depth = glm::dot(from_eye, rays.forward);
        return glm::dvec2(glm::dot(from_eye, rays.right) / glm::dot(rays.right, rays.right) * width,
                          glm::dot(from_eye, rays.up) / glm::dot(rays.up, rays.up) * height) *
               (0.5 / depth);
    };
    int by_mesh = 0;
    int by_rays = 0;
    for (const double t : {0.1, 0.3, 0.6, 1.2}) {
        const std::vector<glm::vec2> drawn = easel.draw(
            ammann, camera, 0, {{"render.ammann_cell_samples", cell}, {"render.ammann_mesh_from_px2", t}});
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                const glm::vec2 shown = drawn[static_cast<std::size_t>(y) * width + x];
                if (std::isinf(shown.x)) continue;
                const glm::dvec3 ray = glm::normalize(rays.middle + (2 * (x + 0.5) / width - 1) * rays.right +
                                                      (2 * (y + 0.5) / height - 1) * rays.up);
                const glm::dvec3 hit = camera.eye + double(shown.x) * ray;
                const glm::dvec2 in_cells =
                    glm::dvec2(grid.column_of(hit.x), grid.row_of(hit.y)) / static_cast<double>(cell);
                const glm::dvec2 within = glm::fract(in_cells);
                if (std::min({within.x, within.y, 1 - within.x, 1 - within.y}) < 0.02) continue;
                glm::dvec2 low(HUGE_VAL);
                glm::dvec2 high(-HUGE_VAL);
                bool behind = false;
                for (int corner = 0; corner < 4; ++corner) {
                    const glm::dvec2 at =
                        (glm::floor(in_cells) + glm::dvec2(corner & 1, corner >> 1)) * double(cell);
                    const glm::dvec3 point(at.x * grid.dx, grid.height_m() - at.y * grid.dy, 0);
                    behind = behind || glm::dot(point - camera.eye, rays.forward) <= 0;
                    low = glm::min(low, place_px(point));
                    high = glm::max(high, place_px(point));
                }
                const double area = (high.x - low.x) * (high.y - low.y) / (cell * cell);
                if (!behind && std::abs(area / t - 1) < 1e-3) continue;
                ASSERT_EQ(shown.y == 1, behind || area > t) << t << ", " << x << ", " << y << ": " << area;
                ++(shown.y == 1 ? by_mesh : by_rays);
            }
    }
    EXPECT_GT(by_mesh, 5000);
    EXPECT_GT(by_rays, 5000);
}

// The bounds of the cells that share samples with changed tiles are found again, and of no others.
TEST(Ammann, AChangeCostsTheCellsThatItTouches) {
    const gpu::Context context;
    const Grid grid{700, 513, 20, 20};
    Simulation simulation(bedrock_terrain(grid, generate_heights(grid, {"mountains", 4, 900})),
                          Parameters(simulation_parameters()));
    const Terrain& terrain = simulation.terrain();
    render::Pyramid pyramid(terrain);
    render::HitsTarget target(width, height);
    const render::Method ammann = render::make_ammann(render::Detail::none);
    const render::Camera camera = render::overview(grid, 0, 900);
    const render::OwnNumbers numbers = {{"render.ammann_cell_samples", 48}};
    const auto refreshed = [&] {
        pyramid.refresh(terrain);
        ammann({terrain, pyramid, camera, width, height, 0, 16, target.framebuffer(), nullptr, numbers});
        return ammann.figures().refreshed_cells;
    };
    const int columns = (grid.nx - 1 + 47) / 48;
    const int rows = (grid.ny - 1 + 47) / 48;
    EXPECT_EQ(refreshed(), columns * rows);
    EXPECT_EQ(refreshed(), 0);
    for (const glm::dvec2 at : {glm::dvec2(3, 3), glm::dvec2(320, 256), glm::dvec2(600, 500)}) {
        Dab dab;
        dab.effect = effect_of(BrushMode::raise);
        dab.x_m = at.x * grid.dx;
        dab.y_m = at.y * grid.dy;
        dab.radius_m = 32 * grid.dx;
        dab.amount_m = 300;
        simulation.apply(dab);
        const std::vector<int> tiles =
            terrain.tiles.touched_by({static_cast<int>(at.x) - 31, static_cast<int>(at.y) - 31, 63, 63});
        int expected = 0;
        for (int row = 0; row < rows; ++row)
            for (int column = 0; column < columns; ++column)
                expected += std::any_of(tiles.begin(), tiles.end(), [&](int tile) {
                    const gpu::Region samples = terrain.tiles.region(tile);
                    return samples.x <= 48 * (column + 1) && samples.x + samples.width > 48 * column &&
                           samples.y <= 48 * (row + 1) && samples.y + samples.height > 48 * row;
                });
        EXPECT_EQ(refreshed(), expected) << at.x << ", " << at.y;
        EXPECT_LT(expected, columns * rows / 4);
        EXPECT_EQ(refreshed(), 0);
    }
}

}  // namespace
}  // namespace talus::ammann_test
