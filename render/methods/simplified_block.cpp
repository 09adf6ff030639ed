#include "render/methods/simplified_block.h"

#include <meshoptimizer.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace talus::render {
namespace {

// What rounding of a double may hide, in parts of the height.
constexpr double rounding = 1e-9;

struct Block {
    std::span<const float> ground;
    glm::ivec2 patches;
    std::vector<float> raised;

    std::size_t index(glm::ivec2 at) const { return static_cast<std::size_t>(at.y) * (patches.x + 1) + at.x; }
    double ground_at(glm::ivec2 at) const { return ground[index(at)]; }
    glm::dvec3 vertex(unsigned number) const {
        const auto row = static_cast<unsigned>(patches.x + 1);
        return {number % row, number / row, raised[number]};
    }
    // Higher than a patch's bilinear surface are its two triangles along the higher diagonal: the ground's
    // upper hull. place: within the block, columns and rows.
    double hull_at(glm::dvec2 place) const {
        const glm::ivec2 at = glm::clamp(glm::ivec2(glm::floor(place)), glm::ivec2(0), patches - 1);
        const glm::dvec2 in = place - glm::dvec2(at);
        const double a = ground_at(at);
        const double b = ground_at(at + glm::ivec2(1, 0));
        const double c = ground_at(at + glm::ivec2(0, 1));
        const double d = ground_at(at + glm::ivec2(1, 1));
        if (a + d >= b + c)
            return in.x >= in.y ? a + in.x * (b - a) + in.y * (d - b) : a + in.y * (c - a) + in.x * (d - c);
        return in.x + in.y <= 1 ? a + in.x * (b - a) + in.y * (c - a)
                                : d + (1 - in.x) * (c - d) + (1 - in.y) * (b - d);
    }
};

using Triangle = std::array<glm::dvec3, 3>;

// Twice its area from above, in patches; rows run south.
double area(const Triangle& t) {
    return (t[1].x - t[0].x) * (t[0].y - t[2].y) - (t[2].x - t[0].x) * (t[0].y - t[1].y);
}

bool over(double height, double hull) {
    return height >= hull - rounding * (1 + std::abs(hull));
}

// Where an edge crosses rows, columns and the patches' diagonals: the hull bends there.
bool edge_is_over(const Block& block, glm::dvec3 from, glm::dvec3 to) {
    const auto over_at = [&](double way) {
        const glm::dvec3 point = glm::mix(from, to, way);
        return over(point.z, block.hull_at(glm::dvec2(point)));
    };
    const auto crossings_are_over = [&](double begin, double end) {
        if (begin == end) return true;
        const double low = std::ceil(std::min(begin, end));
        for (double line = low; line <= std::max(begin, end); ++line)
            if (!over_at((line - begin) / (end - begin))) return false;
        return true;
    };
    return crossings_are_over(from.x, to.x) && crossings_are_over(from.y, to.y) &&
           crossings_are_over(from.x + from.y, to.x + to.y) &&
           crossings_are_over(from.x - from.y, to.x - to.y);
}

bool samples_are_over(const Block& block, const Triangle& t) {
    const double whole = area(t);
    const glm::ivec2 low(glm::min(glm::min(t[0], t[1]), t[2]));
    const glm::ivec2 high(glm::max(glm::max(t[0], t[1]), t[2]));
    for (int y = low.y; y <= high.y; ++y)
        for (int x = low.x; x <= high.x; ++x) {
            const glm::dvec3 at(x, y, 0);
            const double u = area({at, t[1], t[2]}) / whole;
            const double v = area({t[0], at, t[2]}) / whole;
            const double w = area({t[0], t[1], at}) / whole;
            if (u < 0 || v < 0 || w < 0) continue;
            if (!over(u * t[0].z + v * t[1].z + w * t[2].z, block.ground_at({x, y}))) return false;
        }
    return true;
}

// The triangles cover the block once and lie over the ground. Those that stand upright close steps: where an
// edge skips a sample of the border, the neighbour's does not.
std::vector<std::uint32_t> checked(const Block& block, std::span<const unsigned> indices) {
    std::vector<std::uint32_t> words;
    double covered = 0;
    for (std::size_t i = 0; i < indices.size(); i += 3) {
        Triangle t;
        std::uint32_t word = 0;
        for (unsigned k = 0; k < 3; ++k) {
            t[k] = block.vertex(indices[i + k]);
            word |= (static_cast<std::uint32_t>(t[k].y) * 9 + static_cast<std::uint32_t>(t[k].x)) << (7 * k);
        }
        if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) continue;
        const double twice = area(t);
        if (twice < 0 || (twice > 0 && !samples_are_over(block, t))) return {};
        for (unsigned k = 0; k < 3; ++k)
            if (!edge_is_over(block, t[k], t[(k + 1) % 3])) return {};
        covered += twice;
        words.push_back(word);
    }
    if (covered != 2.0 * block.patches.x * block.patches.y) return {};
    return words;
}

// Two triangles a patch, along the higher diagonal.
std::vector<unsigned> full_mesh(const Block& block) {
    std::vector<unsigned> indices;
    indices.reserve(static_cast<std::size_t>(6) * block.patches.x * block.patches.y);
    for (int y = 0; y < block.patches.y; ++y)
        for (int x = 0; x < block.patches.x; ++x) {
            const auto a = static_cast<unsigned>(block.index({x, y}));
            const unsigned b = a + 1;
            const unsigned c = a + static_cast<unsigned>(block.patches.x) + 1;
            const unsigned d = c + 1;
            const bool falling = block.raised[a] + block.raised[d] >= block.raised[b] + block.raised[c];
            const std::array<unsigned, 6> corners = falling ? std::array<unsigned, 6>{a, c, d, a, d, b}
                                                            : std::array<unsigned, 6>{a, c, b, b, c, d};
            indices.insert(indices.end(), corners.begin(), corners.end());
        }
    return indices;
}

}  // namespace

std::vector<float> raised_samples(std::span<const float> ground, glm::ivec2 patches) {
    const int row = patches.x + 1;
    std::vector<float> raised(ground.begin(), ground.end());
    for (int y = 1; y < patches.y; ++y)
        for (int x = 1; x < patches.x; ++x) {
            float& sample = raised[static_cast<std::size_t>(y) * row + x];
            for (int j = -1; j <= 1; ++j)
                for (int i = -1; i <= 1; ++i)
                    sample = std::max(sample, ground[static_cast<std::size_t>(y + j) * row + x + i]);
        }
    return raised;
}

std::vector<std::uint32_t> simplify_block(std::span<const float> ground, glm::ivec2 patches,
                                          glm::dvec2 spacing_m, std::size_t most) {
    const Block block{ground, patches, raised_samples(ground, patches)};
    const std::vector<unsigned> full = full_mesh(block);
    std::vector<glm::vec3> vertices(block.raised.size());
    // Heights from the lowest on: the simplifier works in floats.
    const float lowest = *std::min_element(block.raised.begin(), block.raised.end());
    for (unsigned i = 0; i < vertices.size(); ++i) {
        const glm::dvec3 vertex = block.vertex(i);
        vertices[i] = glm::vec3(glm::dvec2(vertex) * spacing_m, block.raised[i] - lowest);
    }
    std::vector<unsigned> fewer(full.size());
    // From the fewest triangles on: the border's 32 samples alone make thirty.
    constexpr std::array<std::size_t, 5> goals = {32, 40, 48, 56, 64};
    for (const std::size_t goal : goals) {
        if (goal > most || 3 * goal > full.size()) break;
        const std::size_t count =
            meshopt_simplify(fewer.data(), full.data(), full.size(), &vertices[0].x, vertices.size(),
                             sizeof(glm::vec3), 3 * goal, 1e9F, meshopt_SimplifyLockBorder, nullptr);
        std::vector<std::uint32_t> words = checked(block, std::span(fewer).first(count));
        if (!words.empty() && words.size() <= most) return words;
    }
    return {};
}

}  // namespace talus::render
