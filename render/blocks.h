#pragma once
#include <cstdint>
#include <glm/glm.hpp>

#include "sim/gpu/program.h"
#include "sim/gpu/texture.h"

namespace talus::render {

namespace glsl {
using uint = std::uint32_t;
#include "render/block_pixels.glsl"
}  // namespace glsl

/// Blocks of a picture in a row and in a column: squares of 32 x 32 pixels, the last ones cut off.
glm::ivec2 blocks_of(int width, int height);

/// Squares of 4 x 4 blocks, which a list may name at once.
glm::ivec2 large_blocks_of(glm::ivec2 blocks);

/// A list on the device of blocks to draw: the four words of an indirect draw, the first of them how many,
/// and their numbers; shaders/render/block_pixels.glsl says how squares of 4 x 4 blocks count as one.
struct BlockList {
    const gpu::Buffer& words;
    std::size_t arguments;  ///< word where the four begin
    std::size_t numbers;    ///< word where the numbers begin
};

/// Draws listed blocks of a picture of this size into the target, with a program of
/// shaders/render/block.vert.
void draw_blocks(gpu::Program& program, const gpu::Framebuffer& target, glm::ivec2 size,
                 const BlockList& list, gpu::Depth depth);

}  // namespace talus::render
