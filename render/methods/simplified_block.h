#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace talus::render {

/// Triangles of one block of the outer mesh after simplification (Jeong & Han 2006, section 4). They lie
/// nowhere under the ground's bilinear patches. Samples of the border stay, and upright triangles close what
/// edges along it leave open, so that blocks join.
///
/// ground: heights of the block's samples, m, rows of patches.x + 1, at most 9 x 9; spacing_m: of columns and
/// rows. Returns a word a triangle, at most `most` of them, counter-clockwise from above: its vertices, seven
/// bits each, as numbers of samples in rows of nine. Empty where no such mesh was found.
std::vector<std::uint32_t> simplify_block(std::span<const float> ground, glm::ivec2 patches,
                                          glm::dvec2 spacing_m, std::size_t most);

/// The outer mesh's heights of the block's samples: each the highest of the 3 x 3 around, those of the border
/// their own. Of a block of the terrain as in shaders/render/envelope.comp.
std::vector<float> raised_samples(std::span<const float> ground, glm::ivec2 patches);

}  // namespace talus::render
