// The method uniform is what its authors describe (Jeong & Han 2006): its envelope lies over the ground, and
// its pixels show what samples as far apart as the terrain's find, block by block. The authors say that this
// misses nothing. It does, and how often is counted here.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <optional>

#include "render/cast_twin.h"
#include "render/measure.h"
#include "render/methods/envelope.h"
#include "render/methods/method.h"
#include "render/methods/simplified_block.h"
#include "render/methods/simplified_envelope.h"
#include "render/survey.h"
#include "sim/gpu/context.h"
#include "sim/passes/brush.h"
#include "sim/terrain/generate.h"
#include "tests/scenes/easel.h"
#include "tests/scenes/scenes.h"

namespace talus::uniform_test {
namespace {

constexpr int width = 192;
constexpr int height = 108;
constexpr int block_patches = 8;

// Over the bilinear surface everywhere, on it along the sides that blocks share, and nowhere higher than the
// samples around.
TEST(Envelope, LiesOverTheGround) {
    const gpu::Context context;
    for (const std::string& name : scenes::names()) {
        const scenes::Scene scene = scenes::make(name);
        const scenes::Easel easel(scene, width, height);
        render::Envelope envelope;
        envelope.refresh(easel.terrain);
        const auto raised = envelope.heights().read_all<float>();
        const Grid& grid = scene.grid;
        const auto at = [&](int x, int y) { return static_cast<std::size_t>(y) * grid.nx + x; };
        long higher = 0;
        for (int y = 0; y < grid.ny; ++y)
            for (int x = 0; x < grid.nx; ++x) {
                const bool shared =
                    x % block_patches == 0 || y % block_patches == 0 || x == grid.nx - 1 || y == grid.ny - 1;
                float expected = scene.heights[at(x, y)];
                for (int j = -1; j <= 1 && !shared; ++j)
                    for (int i = -1; i <= 1; ++i)
                        expected = std::max(expected, scene.heights[at(x + i, y + j)]);
                ASSERT_EQ(raised[at(x, y)], expected) << name << " at " << x << ", " << y;
                higher += expected > scene.heights[at(x, y)] ? 1 : 0;
            }
        EXPECT_GT(higher, static_cast<long>(grid.count()) / 50) << "nothing was raised";
        for (int y = 0; y + 1 < grid.ny; ++y)
            for (int x = 0; x + 1 < grid.nx; ++x) {
                const double a = raised[at(x, y)];
                const double b = raised[at(x + 1, y)];
                const double c = raised[at(x, y + 1)];
                const double d = raised[at(x + 1, y + 1)];
                const glm::dvec4 z(scene.heights[at(x, y)], scene.heights[at(x + 1, y)],
                                   scene.heights[at(x, y + 1)], scene.heights[at(x + 1, y + 1)]);
                for (const double v : {0.0, 0.2, 0.5, 0.7, 1.0})
                    for (const double u : {0.0, 0.3, 0.5, 0.9, 1.0}) {
                        const double ground =
                            (1 - v) * ((1 - u) * z.x + u * z.y) + v * ((1 - u) * z.z + u * z.w);
                        // The higher of both diagonals' triangles.
                        const double falling =
                            u >= v ? a + u * (b - a) + v * (d - b) : a + v * (c - a) + u * (d - c);
                        const double rising = u + v <= 1 ? a + u * (b - a) + v * (c - a)
                                                         : d + (1 - u) * (c - d) + (1 - v) * (b - d);
                        const double triangles = a + d >= b + c ? falling : rising;
                        ASSERT_GE(triangles, ground - 1e-9 * (1 + std::abs(ground)))
                            << name << " at " << x << ", " << y;
                    }
            }
    }
}

struct Corner {
    glm::dvec2 place;
    double height_m;
};

// The height of a triangle over a place; none: beside it.
std::optional<double> height_over(const std::array<Corner, 3>& t, glm::dvec2 place) {
    const auto area = [](glm::dvec2 a, glm::dvec2 b, glm::dvec2 c) {
        return (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
    };
    const double whole = area(t[0].place, t[1].place, t[2].place);
    if (whole == 0) return std::nullopt;
    const double u = area(place, t[1].place, t[2].place) / whole;
    const double v = area(t[0].place, place, t[2].place) / whole;
    const double w = 1 - u - v;
    if (std::min({u, v, w}) < -1e-12) return std::nullopt;
    return u * t[0].height_m + v * t[1].height_m + w * t[2].height_m;
}

std::vector<std::array<Corner, 3>> triangles_of(const std::vector<std::uint32_t>& words,
                                                const std::vector<float>& raised, glm::ivec2 patches) {
    std::vector<std::array<Corner, 3>> triangles;
    for (const std::uint32_t word : words) {
        std::array<Corner, 3> triangle;
        for (unsigned k = 0; k < 3; ++k) {
            const auto vertex = static_cast<int>(word >> (7 * k) & 127U);
            const glm::ivec2 at(vertex % 9, vertex / 9);
            EXPECT_TRUE(at.x <= patches.x && at.y <= patches.y);
            triangle[k] = {glm::dvec2(at), raised[static_cast<std::size_t>(at.y) * (patches.x + 1) + at.x]};
        }
        triangles.push_back(triangle);
    }
    return triangles;
}

std::vector<float> block_of(const Grid& grid, const std::vector<float>& heights, glm::ivec2 first,
                            glm::ivec2 patches) {
    std::vector<float> samples;
    for (int y = first.y; y <= first.y + patches.y; ++y)
        for (int x = first.x; x <= first.x + patches.x; ++x)
            samples.push_back(heights[static_cast<std::size_t>(y) * grid.nx + x]);
    return samples;
}

// Simplified blocks are still an envelope: wherever one looks, the bilinear surface lies under them, and
// along the border they are the unsimplified mesh.
TEST(Envelope, SimplifiedLiesOverTheGround) {
    for (const std::string& name : scenes::names()) {
        const scenes::Scene scene = scenes::make(name);
        const Grid& grid = scene.grid;
        long blocks = 0;
        long simplified = 0;
        long triangles_left = 0;
        for (int y0 = 0; y0 + 1 < grid.ny; y0 += block_patches)
            for (int x0 = 0; x0 + 1 < grid.nx; x0 += block_patches) {
                const glm::ivec2 patches =
                    glm::min(glm::ivec2(grid.nx - 1 - x0, grid.ny - 1 - y0), block_patches);
                const std::vector<float> ground = block_of(grid, scene.heights, {x0, y0}, patches);
                const auto words = render::simplify_block(ground, patches, {grid.dx, grid.dy}, 64);
                ++blocks;
                if (words.empty()) continue;
                ++simplified;
                triangles_left += static_cast<long>(words.size());
                ASSERT_LE(words.size(), 64U);
                const auto triangles = triangles_of(words, render::raised_samples(ground, patches), patches);
                const int row = patches.x + 1;
                for (int j = 0; j <= 4 * patches.y; ++j)
                    for (int i = 0; i <= 4 * patches.x; ++i) {
                        const glm::dvec2 place(i / 4.0, j / 4.0);
                        const glm::ivec2 at = glm::min(glm::ivec2(place), patches - 1);
                        const glm::dvec2 in = place - glm::dvec2(at);
                        const std::size_t a = static_cast<std::size_t>(at.y) * row + at.x;
                        const double bilinear =
                            (1 - in.y) * ((1 - in.x) * ground[a] + in.x * ground[a + 1]) +
                            in.y * ((1 - in.x) * ground[a + row] + in.x * ground[a + row + 1]);
                        bool covered = false;
                        for (const auto& triangle : triangles) {
                            const auto height_m = height_over(triangle, place);
                            if (!height_m) continue;
                            covered = true;
                            ASSERT_GE(*height_m, bilinear - 1e-8 * (1 + std::abs(bilinear)))
                                << name << " " << x0 << ", " << y0;
                        }
                        ASSERT_TRUE(covered)
                            << name << " " << x0 << ", " << y0 << " at " << place.x << ", " << place.y;
                    }
            }
        std::printf("%s: %ld of %ld blocks simplified, to %.1f of 128 triangles\n", name.c_str(), simplified,
                    blocks,
                    static_cast<double>(triangles_left) / static_cast<double>(std::max(simplified, 1L)));
        EXPECT_GT(simplified, 0) << name;
    }
}

// What the thread made is on the device, block by block: after everything, and after a change.
TEST(Envelope, KeepsTheSimplifiedBlocks) {
    const gpu::Context context;
    const scenes::Scene scene = scenes::make("spikes");
    const Grid& grid = scene.grid;
    scenes::Easel easel(scene, width, height);
    Brush brush(easel.terrain);
    render::Envelope envelope;
    render::SimplifiedEnvelope simplified;
    for (const bool changed : {false, true}) {
        if (changed)
            brush.dab(easel.terrain, {RaiseDab{}, grid.width_m() / 2, grid.height_m() / 3, grid.width_m() / 8,
                                      1, grid.width_m() / 20, 0, 0, Material::bedrock});
        envelope.refresh(easel.terrain);
        simplified.finish(easel.terrain, envelope);
        EXPECT_EQ(simplified.versions().read_all<float>(), envelope.versions().read_all<float>());
        const auto heights = easel.terrain.ground.read_all<float>();
        const auto words = simplified.triangles().read_all<std::uint32_t>();
        const int columns = easel.terrain.tiles.columns();
        for (int y0 = 0; y0 + 1 < grid.ny; y0 += block_patches)
            for (int x0 = 0; x0 + 1 < grid.nx; x0 += block_patches) {
                const glm::ivec2 patches =
                    glm::min(glm::ivec2(grid.nx - 1 - x0, grid.ny - 1 - y0), block_patches);
                auto expected = render::simplify_block(block_of(grid, heights, {x0, y0}, patches), patches,
                                                       {grid.dx, grid.dy}, 64);
                if (expected.empty()) expected = {0xffffffff};
                expected.resize(64);
                const std::size_t tile = static_cast<std::size_t>(y0 / 64) * columns + x0 / 64;
                const std::size_t block = static_cast<std::size_t>(y0 % 64 / 8) * 8 + x0 % 64 / 8;
                const auto begin = words.begin() + static_cast<std::ptrdiff_t>((tile * 64 + block) * 64);
                ASSERT_TRUE(std::equal(expected.begin(), expected.end(), begin)) << x0 << ", " << y0;
            }
    }
}

// The simplified envelope saves triangles and changes no picture: not where it is there, and not where the
// ground has changed since it was made. What differs is which of two blocks a ray along their side is in, by
// rounding.
TEST(Uniform, DrawsTheSameSimplified) {
    const gpu::Context context;
    for (const std::string& name : scenes::names()) {
        const scenes::Scene scene = scenes::make(name);
        scenes::Easel easel(scene, width, height);
        Brush brush(easel.terrain);
        const render::Method kept = render::make_uniform(render::Detail::none);
        const auto survey = render::survey(scene.grid, scene.heights);
        long pixels = 0;
        long otherwise = 0;
        const auto compare = [&](std::size_t stride) {
            for (std::size_t view = 0; view < survey.size(); view += stride) {
                // A new method's first picture is of the raised mesh alone.
                const render::Method first = render::make_uniform(render::Detail::none);
                const auto expected = scenes::distances(easel.draw(first, survey[view].camera, 0));
                const auto shown = scenes::distances(easel.draw(kept, survey[view].camera, 0));
                for (std::size_t i = 0; i < shown.size(); ++i) otherwise += shown[i] != expected[i] ? 1 : 0;
                pixels += static_cast<long>(shown.size());
            }
        };
        easel.draw(kept, survey.front().camera, 0);
        const long raised_triangles = kept.figures().triangles;
        kept.finish(easel.terrain);
        easel.draw(kept, survey.front().camera, 0);
        const long triangles = kept.figures().triangles;
        EXPECT_LT(triangles, raised_triangles) << name;
        compare(1);
        brush.dab(easel.terrain,
                  {RaiseDab{}, scene.grid.width_m() / 2, scene.grid.height_m() / 2, scene.grid.width_m() / 6,
                   1, scene.grid.width_m() / 20, 0, 0, Material::bedrock});
        easel.pyramid.refresh(easel.terrain);
        compare(4);
        kept.finish(easel.terrain);
        compare(4);
        std::printf("%s: %ld triangles, %ld before; %ld of %ld pixels differ\n", name.c_str(), triangles,
                    raised_triangles, otherwise, pixels);
        EXPECT_LE(100000 * otherwise, pixels) << name;
    }
}

struct Differing {
    long otherwise = 0;
    long pixels = 0;
};

// Pixels that show another place than the same samples in double, over the survey's cameras.
Differing from_samples_in_double(const Grid& grid, const std::vector<float>& heights) {
    const render::Method uniform = render::make_uniform(render::Detail::none);
    scenes::Easel easel({grid, heights}, width, height);
    maths::CastTwin<double> twin(grid, heights);
    Differing result;
    for (const render::NamedCamera& view : render::survey(grid, heights)) {
        const std::vector<float> drawn = scenes::distances(easel.draw(uniform, view.camera, 0));
        twin.look(grid, view.camera, width, height);
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                const double found =
                    twin.sample_pixel(2 * (x + 0.5) / width - 1, 2 * (y + 0.5) / height - 1, block_patches)
                        .distance_m;
                const double shown = drawn[static_cast<std::size_t>(y) * width + x];
                ++result.pixels;
                if (found < 0 ? std::isfinite(shown)
                              : !(std::abs(shown - found) <= 1e-3 * std::max(found, 1e-3)))
                    ++result.otherwise;
            }
    }
    return result;
}

// Every pixel against the same samples in double. What differs is rounding: which side of a plane between two
// blocks a ray is on, and whether a sample is on the ground to its last digits.
TEST(Uniform, DrawsWhatItsSamplesFind) {
    const gpu::Context context;
    for (const std::string& name : scenes::names()) {
        const scenes::Scene scene = scenes::make(name);
        const auto [otherwise, pixels] = from_samples_in_double(scene.grid, scene.heights);
        std::printf("%s: %ld of %ld pixels differ from the samples in double\n", name.c_str(), otherwise,
                    pixels);
        EXPECT_LE(1000 * otherwise, pixels) << name;
    }
}

// The same of terrains of a few samples, and of narrow ones, whose pyramid has no cells as large as a block.
TEST(Uniform, DrawsSmallAndNarrowTerrains) {
    const gpu::Context context;
    for (const glm::ivec2 size : {glm::ivec2(2, 2),
                                  {3, 5},
                                  {9, 9},
                                  {10, 10},
                                  {13, 12},
                                  {20, 19},
                                  {26, 27},
                                  {34, 34},
                                  {2, 100},
                                  {10, 300},
                                  {300, 10},
                                  {11, 513}}) {
        const Grid grid{size.x, size.y, 10, 12};
        const auto [otherwise, pixels] =
            from_samples_in_double(grid, generate_heights(grid, {"hills", 3, 40}));
        std::printf("%d x %d: %ld of %ld pixels differ from the samples in double\n", size.x, size.y,
                    otherwise, pixels);
        EXPECT_LE(1000 * otherwise, pixels) << size.x << " x " << size.y;
    }
}

// Against the reference: what is missed lies between two samples, and no pixel shows what lies nearer than
// the ground by more than a sample.
TEST(Uniform, MissesWhatIsThinnerThanASample) {
    const gpu::Context context;
    const render::Method uniform = render::make_uniform(render::Detail::none);
    for (const std::string& name : scenes::names()) {
        const scenes::Scene scene = scenes::make(name);
        scenes::Easel easel(scene, width, height);
        render::Measure measure(scene.grid, scene.heights);
        const double spacing_m = std::hypot(scene.grid.dx, scene.grid.dy);
        long missed = 0;
        long nearer = 0;
        long hit = 0;
        for (const render::NamedCamera& view : render::survey(scene.grid, scene.heights)) {
            const std::vector<float> drawn = scenes::distances(easel.draw(uniform, view.camera, 0));
            const std::vector<double> truth = measure.reference(view.camera, width, height);
            for (std::size_t i = 0; i < truth.size(); ++i) {
                if (std::isinf(truth[i])) continue;
                ++hit;
                missed += drawn[i] > truth[i] + 4 * spacing_m ? 1 : 0;
                nearer += drawn[i] < truth[i] - 4 * spacing_m ? 1 : 0;
            }
        }
        std::printf("%s: of %ld pixels that are hit, %ld show what lies behind, %ld what lies before\n",
                    name.c_str(), hit, missed, nearer);
        EXPECT_GT(missed, 0) << "the authors' claim holds here: the comparison proves nothing";
        EXPECT_LE((name == "spikes" ? 10 : 50) * missed, hit) << name;
        EXPECT_EQ(nearer, 0) << name;
    }
}

}  // namespace
}  // namespace talus::uniform_test
