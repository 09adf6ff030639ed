#include "render/shade_list.h"

#include <array>

namespace talus::render {
namespace {

// Two draws: of blocks with nothing and with something in them.
constexpr std::size_t shade_head_words = 2 * glsl::draw_words;

}  // namespace

void ShadeList::make(const gpu::Texture& hits, int width, int height, bool skips_walls) {
    const glm::ivec2 blocks = blocks_of(width, height);
    blocks_ = static_cast<std::size_t>(blocks.x) * blocks.y;
    const std::size_t bytes = (shade_head_words + 2 * blocks_) * sizeof(std::uint32_t);
    if (words_.bytes() != bytes) words_ = gpu::Buffer("shading blocks", bytes);
    const std::array<std::uint32_t, shade_head_words> none = {0, 1, 0, 0, 0, 1, 0, 0};
    words_.write(0, std::as_bytes(std::span(none)));
    program_.bind_sampled("hits", hits);
    program_.bind_storage("ShadeBlocks", words_);
    program_.set("blocks", blocks);
    program_.set("size", glm::ivec2(width, height));
    program_.set("skips_walls", skips_walls ? 1 : 0);
    const glm::ivec2 groups = large_blocks_of(blocks);
    program_.dispatch(groups.x, groups.y);
    gpu::barrier({gpu::Use::storage, gpu::Use::indirect, gpu::Use::buffer_transfer});
}

BlockList ShadeList::nothing() const {
    return {words_, 0, shade_head_words};
}

BlockList ShadeList::something() const {
    return {words_, glsl::draw_words, shade_head_words + blocks_};
}

}  // namespace talus::render
