#include "render/blocks.h"

namespace talus::render {
using glsl::block_pixels;
using glsl::large_block;

glm::ivec2 blocks_of(int width, int height) {
    return (glm::ivec2(width, height) + block_pixels - 1) / block_pixels;
}

glm::ivec2 large_blocks_of(glm::ivec2 blocks) {
    return (blocks + large_block - 1) / large_block;
}

void draw_blocks(gpu::Program& program, const gpu::Framebuffer& target, glm::ivec2 size,
                 const BlockList& list, gpu::Depth depth) {
    const glm::ivec2 blocks = blocks_of(size.x, size.y);
    // OpenGL drops a point whose centre lies outside the viewport. So the viewport holds whole blocks, and
    // the clip region cuts them off.
    const glm::ivec2 whole = large_blocks_of(blocks) * (large_block * block_pixels);
    target.bind({0, 0, whole.x, whole.y}, {0, 0, size.x, size.y});
    program.set("blocks", blocks);
    program.set("first_word", static_cast<int>(list.numbers));
    program.bind_storage("BlockList", list.words);
    program.draw_points_indirect(list.words, list.arguments * sizeof(std::uint32_t), depth);
    target.bind({0, 0, size.x, size.y});
}

}  // namespace talus::render
