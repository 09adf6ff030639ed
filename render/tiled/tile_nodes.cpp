#include "render/tiled/tile_nodes.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "sim/error.h"

namespace talus::render {
namespace {

// As tile_node_texel() of shaders/render/tile_nodes.glsl: each level has room for its rows below the one
// before.
int first_node_row(int rows, int level) {
    return 2 * rows - ((2 * rows) >> level) + level;
}

int node_rows(const TileTree& tree) {
    return first_node_row(tree.level(0).tiles.y, tree.top_level()) + tree.level(tree.top_level()).tiles.y;
}

// The slot of a node that lies in a tile that is drawn (shaders/maths/tile_cast.glsl).
constexpr float no_node = -2;

}  // namespace

TileNodes::TileNodes(const TileTree& tree) {
    const glm::ivec2 finest = tree.level(0).tiles;
    const int rows = node_rows(tree);
    if (std::max(finest.x, rows) > gpu::widest_texture)
        throw Error(
            fmt::format("{} x {} tiles are more than the device's largest image holds", finest.x, finest.y));
    nodes_ = gpu::Texture("nodes of tiles", gpu::Format::rg32f, finest.x, rows);
    nodes_.fill(no_node);
}

std::size_t TileNodes::bytes_of(const TileTree& tree) {
    return gpu::texel_bytes(gpu::Format::rg32f) * static_cast<std::size_t>(tree.level(0).tiles.x) *
           static_cast<std::size_t>(node_rows(tree));
}

void TileNodes::tell(const TileTree& tree, const std::vector<TileNode>& nodes) {
    Texels now;
    for (const TileNode& node : nodes) now[tree.index_of(node.tile)] = {node.highest_m, node.slot};
    Texels changed;
    for (const auto& [index, texel] : told_)
        if (!now.contains(index)) changed[index] = glm::vec2(no_node);
    for (const auto& [index, texel] : now) {
        const auto told = told_.find(index);
        if (told == told_.end() || told->second != texel) changed[index] = texel;
    }
    told_ = std::move(now);
    std::vector<glm::vec2> run;
    for (auto one = changed.begin(); one != changed.end();) {
        const std::size_t first = one->first;
        const TileId tile = tree.tile_at(first);
        const auto row_end = first + static_cast<std::size_t>(tree.level(tile.level).tiles.x - tile.column);
        for (run.clear(); one != changed.end() && one->first == first + run.size() && one->first < row_end;
             ++one)
            run.push_back(one->second);
        const int row = first_node_row(tree.level(0).tiles.y, tile.level) + tile.row;
        nodes_.write({tile.column, row, static_cast<int>(run.size()), 1}, std::as_bytes(std::span(run)));
    }
}

}  // namespace talus::render
