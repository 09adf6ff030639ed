#include "tests/bench/finest_surface.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace talus::bench {
namespace {

constexpr std::size_t most_held = 256;  // tiles, 65 MiB

// Where a ray is in a rectangle: from and to, in its lengths; from > to where it nowhere is.
glm::dvec2 stretch_within(glm::dvec2 eye, glm::dvec2 way, glm::dvec2 low, glm::dvec2 high) {
    glm::dvec2 stretch(-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity());
    for (int axis = 0; axis < 2; ++axis) {
        if (way[axis] == 0) {
            if (eye[axis] < low[axis] || eye[axis] > high[axis]) return {1, 0};
            continue;
        }
        const double a = (low[axis] - eye[axis]) / way[axis];
        const double b = (high[axis] - eye[axis]) / way[axis];
        stretch = {std::max(stretch.x, std::min(a, b)), std::min(stretch.y, std::max(a, b))};
    }
    return stretch;
}

// Where a ray has a whole column or row, from and to included: there a bilinear surface can be highest under
// it.
std::vector<double> crossings(glm::dvec2 begin, glm::dvec2 step, double from, double to) {
    std::vector<double> all = {from, to};
    for (int axis = 0; axis < 2; ++axis) {
        if (step[axis] == 0) continue;
        const double a = begin[axis] + from * step[axis];
        const double b = begin[axis] + to * step[axis];
        for (double whole = std::ceil(std::min(a, b)); whole <= std::max(a, b); ++whole)
            all.push_back(std::clamp((whole - begin[axis]) / step[axis], from, to));
    }
    return all;
}

}  // namespace

FinestSurface::FinestSurface(const app::TiledTerrain& terrain)
    : terrain_(terrain), grid_(terrain.tree.grid()), read_(terrain.make_reader()) {}

TileId FinestSurface::tile_under(glm::dvec2 patch) const {
    const glm::ivec2 inside =
        glm::clamp(glm::ivec2(patch), glm::ivec2(0), glm::ivec2(grid_.nx, grid_.ny) - 2);
    return {0, inside.x / terrain_.tree.side(), inside.y / terrain_.tree.side()};
}

const std::vector<float>& FinestSurface::heights_of(const TileId& tile) {
    const std::size_t index = terrain_.tree.index_of(tile);
    if (const auto found = held_.find(index); found != held_.end()) return found->second;
    if (held_.size() >= most_held) held_.clear();
    std::vector<float>& heights = held_[index];
    read_(0, {terrain_.tree.first_patch(tile), glm::ivec2(terrain_.tree.side() + 1)}, heights);
    return heights;
}

std::optional<double> FinestSurface::height_m(glm::dvec2 place_m) {
    const glm::dvec2 at(grid_.column_of(place_m.x), grid_.row_of(place_m.y));
    if (at.x < 0 || at.y < 0 || at.x > grid_.nx - 1 || at.y > grid_.ny - 1) return std::nullopt;
    const glm::ivec2 patch = glm::min(glm::ivec2(at), glm::ivec2(grid_.nx, grid_.ny) - 2);
    const TileId tile = tile_under(patch);
    const std::vector<float>& heights = heights_of(tile);
    const glm::ivec2 corner = patch - terrain_.tree.first_patch(tile);
    const auto sample = [&](int x, int y) {
        return static_cast<double>(heights[static_cast<std::size_t>(corner.y + y) *
                                               static_cast<std::size_t>(terrain_.tree.side() + 1) +
                                           static_cast<std::size_t>(corner.x + x)]);
    };
    const glm::dvec2 in = at - glm::dvec2(patch);
    return std::lerp(std::lerp(sample(0, 0), sample(1, 0), in.x), std::lerp(sample(0, 1), sample(1, 1), in.x),
                     in.y);
}

void FinestSurface::along(glm::dvec3 eye, glm::dvec3 way, double length_m,
                          const std::function<void(glm::dvec3 place, double height_m)>& visit) {
    // In columns and rows.
    const glm::dvec2 begin(grid_.column_of(eye.x), grid_.row_of(eye.y));
    const glm::dvec2 step(way.x / grid_.dx, -way.y / grid_.dy);
    if (step == glm::dvec2(0)) return;  // straight down: it passes nothing
    const glm::dvec2 over =
        stretch_within(begin, step, glm::dvec2(0), glm::dvec2(grid_.nx - 1, grid_.ny - 1));
    const double end = std::min(length_m, over.y);
    // A thousandth of a patch on, it is in the tile that it enters.
    const double little = 1e-3 / std::max(std::abs(step.x), std::abs(step.y));
    double at = std::max(0.0, over.x);
    while (at < end) {
        const TileId tile = tile_under(begin + (at + little) * step);
        const glm::dvec2 inside =
            stretch_within(begin, step, terrain_.tree.first_patch(tile), terrain_.tree.last_patch(tile));
        const double out = std::min(end, std::max(inside.y, at + little));
        const double lowest_m = eye.z + std::min(at * way.z, out * way.z);
        if (lowest_m <= static_cast<double>(terrain_.bounds[terrain_.tree.index_of(tile)].highest_m))
            for (const double crossing : crossings(begin, step, at, out)) {
                const glm::dvec3 place = eye + crossing * way;
                if (const auto ground_m = height_m(place)) visit(place, *ground_m);
            }
        at = out;
    }
}

}  // namespace talus::bench
