// What a photo in tiles costs a frame, whatever its size.
#include <fmt/format.h>

#include <cstdint>

#include "app/core/tile_room.h"
#include "render/tiled/photo_surface.h"
#include "render/tiled/tiled_renderer.h"
#include "sim/terrain/generate.h"
#include "tests/bench/measure.h"
#include "tests/scenes/load_tiles.h"

namespace talus::bench {
namespace {

constexpr Grid under_photo{2049, 2049, 15, 15};
constexpr glm::ivec2 photo_picture(width, height);
constexpr int whole_side = 4096;  // of the picture that is held as a whole
constexpr int photo_mib = 128;

// Colours of a place, of any level: nothing of it is held.
PhotoTexel colour_of(int level, int x, int y) {
    const unsigned mixed =
        (static_cast<unsigned>(x) * 2654435761U ^ static_cast<unsigned>(y) * 2246822519U) * 747796405U;
    const auto broad = static_cast<unsigned>(((x << level) >> 9) * 37 + ((y << level) >> 9) * 61);
    const auto channel = [&](unsigned shift) {
        return static_cast<std::uint8_t>(60 + (broad >> shift) % 90 + (mixed >> (shift + 8)) % 50);
    };
    return {channel(0), channel(1), channel(3), 255};
}

void read_colours(int level, const TileSamples& samples, std::vector<PhotoTexel>& texels) {
    texels.clear();
    for (int y = 0; y < samples.count.y; ++y)
        for (int x = 0; x < samples.count.x; ++x)
            texels.push_back(colour_of(level, samples.first.x + x, samples.first.y + y));
}

// A photo of so many texels a side, with the tiles that a picture wants.
class LoadedPhoto {
  public:
    LoadedPhoto(int side, const HeightsBetween& heights)
        : place_{glm::dvec2(-0.5), glm::dvec2(side) / 2048.0},
          tree_(photo_tree(glm::ivec2(side), under_photo, place_)),
          surface_(tree_, photo_bounds(tree_, place_, heights),
                   app::slots_within({"tiles.photo_mib", photo_mib, "the photo"}, tree_,
                                     render::PhotoSurface::bytes_of_slot(tree_))),
          read_(with_smaller_pictures(read_colours, render::PhotoSurface::halvings)) {
        put(tree_.coarsest_tiles());
    }

    render::LaidPhoto laid(const render::Camera& camera) {
        const render::LaidPhoto photo{&surface_, place_, ++changes_, true};
        const render::Camera over = photo.camera_over(under_photo, camera);
        for (;;) {
            const render::TileChoice& choice = surface_.look(over, photo_picture, 1);
            drawn = choice.drawn.size();
            tolerance_px = choice.tolerance_px;
            if (choice.wanted.empty()) return photo;
            put(std::vector<TileId>(choice.wanted));
        }
    }
    double mib() const { return static_cast<double>(surface_.bytes()) / (1 << 20); }

    std::size_t drawn = 0;
    double tolerance_px = 0;

  private:
    void put(const std::vector<TileId>& tiles) {
        std::vector<PhotoTexel> texels;
        for (const TileId& tile : tiles) {
            read_(tile.level, render::PhotoSurface::samples_of(tree_, tile), texels);
            surface_.put(tile, texels);
        }
    }

    PhotoPlace place_;
    TileTree tree_;
    render::PhotoSurface surface_;
    ReadTexels read_;
    std::uint64_t changes_ = 0;
};

}  // namespace

void bench_photo() {
    const std::vector<float> heights = generate_heights(under_photo, {"mountains", 4, 2500});
    const scenes::MemoryTiles tiles(under_photo, heights, 256);
    render::TiledSurface surface(tiles.tree(), tiles.bounds(), static_cast<int>(tiles.tree().count()));
    scenes::put_coarsest(surface, tiles);
    render::TiledRenderer bare;
    render::TiledRenderer draped;
    {
        std::vector<PhotoTexel> picture;
        read_colours(0, {glm::ivec2(0), glm::ivec2(whole_side)}, picture);
        draped.drape(whole_side, whole_side, std::as_bytes(std::span(picture)));
    }
    const std::vector<std::pair<std::string, render::Camera>> cameras = {
        {"over it", {{15000, -12000, 14000}, {15000, 14000, 800}, 50}},
        {"flying", {{9000, 9000, 2900}, {15000, 13000, 1500}, 55}},
        {"down", {{15000, 15000, 6000}, {15000, 15001, 0}, 50}}};
    for (const int side : {4096, 16384, 65536, 262144}) {
        LoadedPhoto photo(side, heights_between(tiles.tree(), tiles.bounds()));
        render::TiledRenderer laid;
        for (const auto& [name, camera] : cameras) {
            render::ViewSettings settings;
            settings.tolerance_px = 2.0 / 3;
            settings.sun = glm::normalize(glm::dvec3(-0.7, 0.6, 0.5));
            scenes::load_tiles(surface, tiles, camera, photo_picture, settings.tolerance_px);
            laid.lay(photo.laid(camera));
            const render::Camera eye = camera;
            const auto draw = [&surface, &settings, eye](render::TiledRenderer& renderer) {
                renderer.draw(surface, eye, settings, width, height);
                const std::vector<std::uint8_t> wait = renderer.read_rgb(1, 1);
            };
            const std::vector<double> seconds =
                interleave({{"materials", [&] { draw(bare); }},
                            {"a picture held as a whole", [&] { draw(draped); }},
                            {"the photo", [&] { draw(laid); }}},
                           7);
            fmt::print(
                "{:>6}² {:<8} materials {:>6.1f} ms, a picture of {}² held as a whole {:>6.1f} ms, the photo "
                "{:>6.1f} ms: {} tiles, within {:.2f} px, {:.1f} MiB\n",
                side, name, 1e3 * seconds[0], whole_side, 1e3 * seconds[1], 1e3 * seconds[2], photo.drawn,
                photo.tolerance_px, photo.mib());
        }
    }
}

}  // namespace talus::bench
