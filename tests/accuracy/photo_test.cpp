// A photo in tiles over a ground: it looks as the same image does that is held as a whole.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <memory>

#include "render/renderer.h"
#include "render/tiled/photo_surface.h"
#include "sim/gpu/context.h"
#include "sim/terrain/generate.h"
#include "sim/tiled/screen_colour.h"

namespace talus::photo_test {
namespace {

constexpr glm::ivec2 size(320, 180);

// An image whose levels are means of the one before, in memory.
class MemoryPhoto {
  public:
    // Patches of colours from coarse to fine, and lines; none repeats.
    explicit MemoryPhoto(glm::ivec2 texels) : sizes_(halved_levels(texels)) {
        levels_.emplace_back();
        for (int y = 0; y < texels.y; ++y)
            for (int x = 0; x < texels.x; ++x) {
                const unsigned coarse = mixed(x / 64, y / 64);
                const unsigned fine = mixed(x / 4, y / 4);
                const bool line = x % 128 < 3 || y % 128 < 3;
                const auto channel = [&](int shift) {
                    return static_cast<std::uint8_t>(line ? 230
                                                          : (coarse >> shift) % 128 + (fine >> shift) % 96);
                };
                levels_.back().push_back({channel(4), channel(10), channel(16), 255});
            }
        for (std::size_t i = 1; i < sizes_.size(); ++i) add_level(i);
    }

    ReadTexels reader() const {
        return [this](int level, const TileSamples& samples, std::vector<PhotoTexel>& texels) {
            texels.clear();
            for (int y = 0; y < samples.count.y; ++y)
                for (int x = 0; x < samples.count.x; ++x)
                    texels.push_back(at(static_cast<std::size_t>(level), samples.first + glm::ivec2(x, y)));
        };
    }
    glm::ivec2 texels() const { return sizes_.front(); }
    const std::vector<PhotoTexel>& finest() const { return levels_.front(); }
    // What is not covered: a quarter of it.
    void clear_south_east() {
        levels_.resize(1);
        for (int y = texels().y / 2; y < texels().y; ++y)
            for (int x = texels().x / 2; x < texels().x; ++x)
                levels_.front()[static_cast<std::size_t>(y) * texels().x + x] = {};
        for (std::size_t i = 1; i < sizes_.size(); ++i) add_level(i);
    }

  private:
    static unsigned mixed(int x, int y) {
        return (static_cast<unsigned>(x) * 2654435761U ^ static_cast<unsigned>(y) * 2246822519U) * 747796405U;
    }
    const PhotoTexel& at(std::size_t level, glm::ivec2 place) const {
        const glm::ivec2 on = glm::clamp(place, glm::ivec2(0), sizes_[level] - 1);
        return levels_[level][static_cast<std::size_t>(on.y) * sizes_[level].x + on.x];
    }
    void add_level(std::size_t number) {
        std::vector<PhotoTexel> texels;
        for (int y = 0; y < sizes_[number].y; ++y)
            for (int x = 0; x < sizes_[number].x; ++x) {
                glm::vec4 sum(0);
                for (int i = 0; i < 4; ++i) {
                    const PhotoTexel& one = at(number - 1, {2 * x + i % 2, 2 * y + i / 2});
                    sum += glm::vec4(from_screen(one.r), from_screen(one.g), from_screen(one.b), one.a);
                }
                sum *= 0.25F;
                texels.push_back({to_screen(sum.r), to_screen(sum.g), to_screen(sum.b),
                                  static_cast<std::uint8_t>(std::lround(sum.a))});
            }
        levels_.push_back(std::move(texels));
    }

    std::vector<glm::ivec2> sizes_;
    std::vector<std::vector<PhotoTexel>> levels_;
};

// A ground with a photo stretched over it, and one with the same image as a whole.
class Gallery {
  public:
    explicit Gallery(const MemoryPhoto& photo, int slots = 400)
        : terrain_(bedrock_terrain(grid, generate_heights(grid, {"hills", 3, 300}))),
          laid_(terrain_, 32),
          draped_(terrain_, 32),
          place_{glm::dvec2(-0.5), glm::dvec2(photo.texels()) / glm::dvec2(grid.nx - 1, grid.ny - 1)},
          surface_(photo_tree(photo.texels(), grid, place_),
                   photo_bounds(photo_tree(photo.texels(), grid, place_), place_,
                                heights_between(grid, generate_heights(grid, {"hills", 3, 300}))),
                   slots),
          read_(with_smaller_pictures(photo.reader(), render::PhotoSurface::halvings)) {
        draped_.drape(photo.texels().x, photo.texels().y, std::as_bytes(std::span(photo.finest())));
        put(surface_.tree().coarsest_tiles());
    }

    // With all tiles that it wants.
    std::vector<std::uint8_t> laid(const render::Camera& camera) {
        const render::LaidPhoto photo{&surface_, place_, ++changes_};
        const render::Camera over = photo.camera_over(grid, camera);
        while (!surface_.look(over, size, 1).wanted.empty()) put(surface_.look(over, size, 1).wanted);
        tolerance_px = surface_.look(over, size, 1).tolerance_px;
        laid_.lay(photo);
        laid_.draw(terrain_, camera, {}, size.x, size.y);
        return laid_.read_rgb(size.x, size.y);
    }
    std::vector<std::uint8_t> draped(const render::Camera& camera) {
        draped_.draw(terrain_, camera, {}, size.x, size.y);
        return draped_.read_rgb(size.x, size.y);
    }
    std::vector<std::uint8_t> bare(const render::Camera& camera) {
        laid_.lay({});
        laid_.draw(terrain_, camera, {}, size.x, size.y);
        return laid_.read_rgb(size.x, size.y);
    }
    const render::PhotoSurface& surface() const { return surface_; }

    static constexpr Grid grid{257, 129, 20, 20};
    double tolerance_px = 0;

  private:
    void put(const std::vector<TileId>& tiles) {
        std::vector<PhotoTexel> texels;
        for (const TileId& tile : tiles) {
            read_(tile.level, render::PhotoSurface::samples_of(surface_.tree(), tile), texels);
            surface_.put(tile, texels);
        }
    }

    Terrain terrain_;
    render::Renderer laid_;
    render::Renderer draped_;
    PhotoPlace place_;
    render::PhotoSurface surface_;
    ReadTexels read_;
    std::uint64_t changes_ = 0;
};

struct Difference {
    double mean = 0;          // of a channel's 256 steps
    double share_of_far = 0;  // of channels that are off by more than 8
};

Difference difference(const std::vector<std::uint8_t>& a, const std::vector<std::uint8_t>& b) {
    Difference found;
    for (std::size_t i = 0; i < a.size(); ++i) {
        const int off = std::abs(static_cast<int>(a[i]) - static_cast<int>(b[i]));
        found.mean += static_cast<double>(off) / static_cast<double>(a.size());
        found.share_of_far += (off > 8 ? 1.0 : 0.0) / static_cast<double>(a.size());
    }
    return found;
}

// From high to low, along the ground, over the edge, straight down.
std::vector<render::Camera> cameras() {
    const glm::dvec3 middle(2560, 1280, 150);
    return {{{2560, -2500, 3000}, middle, 50},        {{2560, 1280, 900}, middle, 60},
            {{400, 400, 420}, {2000, 1000, 50}, 50},  {{5000, 2400, 350}, {4000, 2000, 300}, 50},
            {{1300, 700, 330}, {1400, 700, 200}, 60}, {{-9000, -6000, 7000}, middle, 40}};
}

TEST(Photos, LookAsTheSameImageHeldAsAWhole) {
    const gpu::Context context;
    const MemoryPhoto photo({4096, 2048});
    Gallery gallery(photo);
    ASSERT_GE(gallery.surface().tree().top_level(), 4);
    for (const render::Camera& camera : cameras()) {
        const Difference off = difference(gallery.laid(camera), gallery.draped(camera));
        EXPECT_LE(off.mean, 0.1) << camera.eye.x;
        // How many taps a footprint has goes by steps.
        EXPECT_LE(off.share_of_far, 0.002) << camera.eye.x;
        EXPECT_GT(difference(gallery.bare(camera), gallery.draped(camera)).mean, 20 * off.mean)
            << camera.eye.x;
    }
}

// Straight down, the picture's right lower quarter is the ground's south-east.
TEST(Photos, LetTheGroundShowWhereTheyDoNotCoverIt) {
    const gpu::Context context;
    MemoryPhoto photo({1024, 512});
    const render::Camera above{{2560, 1280, 2900}, {2560, 1280, 0}, 50};
    const std::vector<std::uint8_t> covered = Gallery(photo).laid(above);
    photo.clear_south_east();
    Gallery gallery(photo);
    const std::vector<std::uint8_t> quartered = gallery.laid(above);
    const std::vector<std::uint8_t> bare = gallery.bare(above);
    const auto at = [](const std::vector<std::uint8_t>& rgb, glm::ivec2 pixel) {
        const std::size_t i = 3 * (static_cast<std::size_t>(pixel.y) * size.x + pixel.x);
        return glm::ivec3(rgb[i], rgb[i + 1], rgb[i + 2]);
    };
    int others = 0;
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x) {
            const bool beside_middle = std::abs(x - size.x / 2) > 4 && std::abs(y - size.y / 2) > 4;
            if (!beside_middle) continue;
            const bool south_east = x > size.x / 2 && y > size.y / 2;
            const glm::ivec3 off = at(quartered, {x, y}) - at(south_east ? bare : covered, {x, y});
            EXPECT_LE(glm::max(std::abs(off.x), glm::max(std::abs(off.y), std::abs(off.z))), 1)
                << x << ' ' << y;
            others += at(bare, {x, y}) != at(covered, {x, y}) ? 1 : 0;
        }
    EXPECT_GT(others, size.x * size.y / 4);
}

TEST(Photos, AreCoarserWhereTheRoomIsTooSmall) {
    const gpu::Context context;
    const MemoryPhoto photo({4096, 2048});
    Gallery gallery(photo, 8);
    Gallery roomy(photo);
    const render::Camera near = cameras()[2];
    const std::vector<std::uint8_t> wanted = roomy.laid(near);
    EXPECT_EQ(roomy.tolerance_px, 1);
    EXPECT_LE(difference(gallery.laid(near), wanted).mean, 12);
    EXPECT_GT(gallery.tolerance_px, 1);
    EXPECT_LT(gallery.surface().bytes(), roomy.surface().bytes() / 10);
}

}  // namespace
}  // namespace talus::photo_test
