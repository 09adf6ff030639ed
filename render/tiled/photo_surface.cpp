#include "render/tiled/photo_surface.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace talus::render {
namespace {

// Texels around those that a tile covers. The longest footprint, 16 taps of up to two texels, ends within.
constexpr int border = 16;

// Of what shaders are told of a slot.
constexpr int place_texels_of_photo = 2;

int texels_across(const TileTree& tree) {
    return tree.room_patches() + 2 * border;
}

// Slots in a row: as few as can be.
int slots_in_row(const TileTree& tree, int slots) {
    const int most = gpu::widest_texture / texels_across(tree);
    return std::min((slots + most - 1) / most, most);
}

// Whole rows, so that no more is held than was asked for.
int slots_that_fit(const TileTree& tree, int slots) {
    const int in_row = slots_in_row(tree, slots);
    const int fit = std::min(slots, in_row * (gpu::widest_texture / texels_across(tree)));
    return std::max(fit / in_row * in_row, std::min(fit, in_row));
}

}  // namespace

TileSamples PhotoSurface::samples_of(const TileTree& tree, const TileId& tile) {
    // Smaller pictures are means of the same texels as coarser levels.
    constexpr int together = 1 << halvings;
    const glm::ivec2 first = tree.first_level_patch(tile) - border;
    return {first - (first % together + together) % together, glm::ivec2(texels_across(tree))};
}

std::size_t PhotoSurface::bytes_of_slot(const TileTree& tree) {
    const auto across = static_cast<std::size_t>(texels_across(tree));
    std::size_t texels = 0;
    for (int i = 0; i <= halvings; ++i) texels += (across >> i) * (across >> i);
    return texels * gpu::texel_bytes(gpu::Format::srgb8) +
           place_texels_of_photo * gpu::texel_bytes(gpu::Format::rgba32f);
}

PhotoSurface::PhotoSurface(const TileTree& tree, std::vector<TileBounds> bounds, int slots)
    : across_(texels_across(tree)),
      slots_(tree, std::move(bounds), slots_that_fit(tree, slots)),
      nodes_(tree),
      in_row_(slots_in_row(tree, slots_.count())) {
    const int rows = (slots_.count() + in_row_ - 1) / in_row_;
    texels_ = gpu::Texture("tiles of the photo", gpu::Format::srgb8, in_row_ * across_, rows * across_,
                           1 + halvings);
    texels_.fill(0);
    texels_.filter(gpu::Wrap::edge, gpu::SmallerLevels::written);
    places_ = gpu::Texture("places in the photo's tiles", gpu::Format::rgba32f, place_texels_of_photo,
                           slots_.count());
}

std::size_t PhotoSurface::bytes() const {
    return static_cast<std::size_t>(slots()) * bytes_of_slot(tree()) + TileNodes::bytes_of(tree());
}

glm::ivec2 PhotoSurface::corner_of(int slot) const {
    return across_ * glm::ivec2(slot % in_row_, slot / in_row_);
}

void PhotoSurface::write(int slot, std::span<const PhotoTexel> texels) {
    const glm::ivec2 corner = corner_of(slot);
    for (int level = 0; level <= halvings; ++level) {
        const int side = across_ >> level;
        const std::size_t count = static_cast<std::size_t>(side) * side;
        texels_.write({corner.x >> level, corner.y >> level, side, side}, std::as_bytes(texels.first(count)),
                      level);
        texels = texels.subspan(count);
    }
}

void PhotoSurface::put_aside(const TileId& tile, std::span<const PhotoTexel> texels) {
    if (const std::optional<int> slot = slots_.put_aside(tile)) write(*slot, texels);
}

const TileChoice& PhotoSurface::look(const Camera& camera, glm::ivec2 size, double tolerance_px) {
    const TileChoice& choice = slots_.look(camera, size, tolerance_px);
    const Grid& grid = tree().grid();
    eye_ = {grid.column_of(camera.eye.x), grid.row_of(camera.eye.y)};
    nodes_.tell(tree(), choice.nodes);
    tell_places();
    return choice;
}

void PhotoSurface::tell_places() {
    std::vector<glm::vec4> texels;
    texels.reserve(2 * static_cast<std::size_t>(slots()));
    for (int slot = 0; slot < slots(); ++slot) {
        const std::optional<TileId> tile = slots_.tile_in(slot);
        if (!tile) {
            texels.resize(texels.size() + 2);
            continue;
        }
        const glm::dvec2 corner = corner_of(slot);
        const glm::dvec2 first = samples_of(tree(), *tile).first;
        // Texels are counted from their middles here, and in an image from its edge.
        const glm::dvec2 eye = corner + tree().place_in(tile->level, eye_) - first + 0.5;
        texels.emplace_back(glm::dvec4(eye, 1.0 / tree().level(tile->level).ratio));
        texels.emplace_back(glm::vec4(corner, corner + static_cast<double>(across_)));
    }
    places_.write(places_.whole(), std::as_bytes(std::span(texels)));
}

void PhotoSurface::bind(gpu::Program& program, glm::dvec2 texels_per_sample) const {
    const Grid& grid = tree().grid();
    program.bind_sampled("photo_texels", texels_);
    program.bind_sampled("photo_nodes", nodes_.texture());
    program.bind_sampled("photo_places", places_);
    program.set("photo_eye", glm::vec2(eye_));
    program.set("photo_scale", glm::vec2(texels_per_sample));
    program.set("photo_patches", glm::ivec2(grid.nx - 1, grid.ny - 1));
    program.set("photo_side_level", tree().side_level());
    program.set("photo_top_level", tree().top_level());
    program.set("photo_rows", tree().level(0).tiles.y);
    program.set("photo_widest", static_cast<float>(1 << halvings));
}

Camera LaidPhoto::camera_over(const Grid& ground, const Camera& camera) const {
    const Grid& photo = surface->tree().grid();
    const glm::dvec3 shift_m(place.first.x * photo.dx,
                             (photo.ny - 1 - place.first.y) * photo.dy - (ground.ny - 1) * ground.dy, 0);
    Camera over = camera;
    over.eye += shift_m;
    over.target += shift_m;
    return over;
}

}  // namespace talus::render
