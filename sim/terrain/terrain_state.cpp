#include "sim/terrain/terrain_state.h"

#include <algorithm>
#include <utility>

#include "sim/terrain/layers.h"

namespace talus {

bool is_on_map(const Grid& grid, glm::dvec2 place_m) {
    const glm::dvec2 slack = 1e-6 * glm::dvec2(grid.dx, grid.dy);
    return place_m.x >= -slack.x && place_m.y >= -slack.y && place_m.x <= grid.width_m() + slack.x &&
           place_m.y <= grid.height_m() + slack.y;
}

void drop_breaches_beside(const Grid& grid, std::vector<Event>& events) {
    std::erase_if(events, [&](const Event& event) {
        return event.breach &&
               !(is_on_map(grid, event.breach->from_m) && is_on_map(grid, event.breach->to_m));
    });
}

std::vector<float> TerrainState::ground() const {
    std::vector<float> heights(bedrock.size());
    for (std::size_t i = 0; i < heights.size(); ++i)
        heights[i] = (bedrock[i].x + regolith[i].x) + (bedrock[i].y + regolith[i].y);
    return heights;
}

std::vector<glm::vec2> TerrainState::ground_words() const {
    std::vector<glm::vec2> words(bedrock.size());
    for (std::size_t i = 0; i < words.size(); ++i) {
        const glm::dvec2 sum = glm::dvec2(bedrock[i]) + glm::dvec2(regolith[i]);
        const double height = sum.x + sum.y;
        words[i].x = static_cast<float>(height);
        words[i].y = static_cast<float>(height - words[i].x);
    }
    return words;
}

TerrainState bedrock_terrain(const Grid& grid, const std::vector<float>& heights_m) {
    check_grid(grid);
    TerrainState state;
    state.grid = grid;
    state.bedrock.reserve(heights_m.size());
    for (const float height : heights_m) state.bedrock.emplace_back(height, 0.0F);
    state.regolith.assign(heights_m.size(), glm::vec2(0));
    return state;
}

void drop_zero_layers(TerrainState& state) {
    for (const LayerDescription& layer : layers()) {
        const std::span<const float> words = words_of(std::as_const(state), layer);
        if (layer.is_optional() &&
            std::all_of(words.begin(), words.end(), [](float word) { return word == 0; }))
            make_layer(state, layer, 0);
    }
}

}  // namespace talus
