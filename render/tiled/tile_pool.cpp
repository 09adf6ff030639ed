#include "render/tiled/tile_pool.h"

#include <algorithm>
#include <cmath>

namespace talus::render {
namespace {

// The level with one cell.
int top_level_of(int patches) {
    int level = 1;
    while (1 << level < patches) ++level;
    return level;
}

// Samples in a row of a slot: one before its first patch, and those of its patches.
int samples_across(int patches) {
    return patches + 2;
}

int slots_across(int patches) {
    return gpu::widest_texture / samples_across(patches);
}

}  // namespace

std::size_t TilePool::bytes_of_slot(const TileTree& tree) {
    const auto patches = static_cast<std::size_t>(tree.room_patches());
    return sizeof(float) * ((patches + 2) * (patches + 2) + patches / 2 * (patches / 2 + patches / 4));
}

TilePool::TilePool(const TileTree& tree, int slots)
    : room_patches_(tree.room_patches()),
      top_level_(top_level_of(room_patches_)),
      // As few as can be: rows of a slot lie near each other then.
      in_row_(std::min((slots + slots_across(room_patches_) - 1) / slots_across(room_patches_),
                       slots_across(room_patches_))),
      slots_(std::min({slots, in_row_ * slots_across(room_patches_), gpu::widest_texture})),
      pyramid_("render/tile_pool.comp") {
    // Whole rows, so that no more is held than was asked for.
    slots_ = std::max(slots_ / in_row_ * in_row_, std::min(slots_, in_row_));
    const int rows = (slots_ + in_row_ - 1) / in_row_;
    const int half = room_patches_ / 2;
    heights_ = gpu::Texture("heights of tiles", gpu::Format::r32f, in_row_ * samples_across(room_patches_),
                            rows * samples_across(room_patches_));
    tops_ = gpu::Texture("pyramids of tiles", gpu::Format::r32f, in_row_ * half, rows * (half + half / 2));
    const auto across = static_cast<std::size_t>(samples_across(room_patches_));
    room_.resize(across * across);
}

std::size_t TilePool::bytes() const {
    return sizeof(float) * (static_cast<std::size_t>(heights_.width()) * heights_.height() +
                            static_cast<std::size_t>(tops_.width()) * tops_.height());
}

void TilePool::write(int slot, glm::ivec2 samples, std::span<const float> heights) {
    const int side = samples_across(room_patches_);
    for (int row = 0; row < side; ++row) {
        const float* from =
            heights.data() + static_cast<std::size_t>(std::min(row, samples.y - 1)) * samples.x;
        float* to = room_.data() + static_cast<std::size_t>(row) * side;
        std::copy(from, from + samples.x, to);
        std::fill(to + samples.x, to + side, from[samples.x - 1]);
    }
    const glm::ivec2 corner = heights_corner(slot);
    heights_.write({corner.x, corner.y, side, side}, std::as_bytes(std::span(room_)));
    written_.push_back(static_cast<std::uint32_t>(slot));
}

glm::ivec2 TilePool::heights_corner(int slot) const {
    return samples_across(room_patches_) * glm::ivec2(slot % in_row_, slot / in_row_);
}

void TilePool::build() {
    if (written_.empty()) return;
    const std::size_t bytes = written_.size() * sizeof(std::uint32_t);
    if (list_.bytes() < bytes) list_ = gpu::Buffer("written slots", bytes);
    list_.write(0, std::as_bytes(std::span(written_)));
    set_layout(pyramid_);
    pyramid_.set("slots_in_row", in_row_);
    pyramid_.bind_sampled("tile_heights", heights_);
    pyramid_.bind_storage("SlotList", list_);
    pyramid_.bind_image("tile_tops", tops_);
    pyramid_.dispatch(static_cast<int>(written_.size()));
    gpu::barrier({gpu::Use::image, gpu::Use::sampler});
    written_.clear();
}

void TilePool::set_layout(gpu::Program& program) const {
    program.set("room_patches", glm::ivec2(room_patches_));
    program.set("slot_top_level", top_level_);
}

void TilePool::bind(gpu::Program& program) const {
    set_layout(program);
    program.bind_sampled("tile_heights", heights_);
    program.bind_sampled("tile_tops", tops_);
}

}  // namespace talus::render
