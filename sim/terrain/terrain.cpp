#include "sim/terrain/terrain.h"

#include <utility>

namespace talus {

std::vector<float> TerrainState::ground() const {
    std::vector<float> heights(bedrock.size());
    for (std::size_t i = 0; i < heights.size(); ++i)
        heights[i] = (bedrock[i].x + regolith[i].x) + (bedrock[i].y + regolith[i].y);
    return heights;
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

Terrain::Terrain(const TerrainState& state)
    : tiles((check_grid(state.grid), state.grid)), grid_(state.grid), ground_program_("sim/ground.comp") {
    const auto image = [&](const char* label, gpu::Format format) {
        return gpu::Texture(label, format, grid_.nx, grid_.ny);
    };
    bedrock = {image("bedrock front", gpu::Format::rg32f), image("bedrock back", gpu::Format::rg32f)};
    regolith = {image("regolith front", gpu::Format::rg32f), image("regolith back", gpu::Format::rg32f)};
    ground = image("ground", gpu::Format::r32f);
    start = image("start", gpu::Format::rg32f);
    const gpu::Region all = ground.whole();
    bedrock.front.write(all, std::as_bytes(std::span(state.bedrock)));
    regolith.front.write(all, std::as_bytes(std::span(state.regolith)));
    std::vector<glm::vec2> words(state.bedrock.size());
    for (std::size_t i = 0; i < words.size(); ++i) {
        const glm::dvec2 sum = glm::dvec2(state.bedrock[i]) + glm::dvec2(state.regolith[i]);
        const double height = sum.x + sum.y;
        words[i].x = static_cast<float>(height);
        words[i].y = static_cast<float>(height - words[i].x);
    }
    start.write(all, std::as_bytes(std::span(words)));
    refresh(all);
}

void Terrain::bind(gpu::Program& program) const {
    bedrock.front.bind_image(0, gpu::Access::read);
    regolith.front.bind_image(1, gpu::Access::read);
    bedrock.back.bind_image(2, gpu::Access::write);
    regolith.back.bind_image(3, gpu::Access::write);
    ground.bind_image(4, gpu::Access::write);
    tiles.flags().bind_storage(0);
    program.set("samples", glm::ivec2(grid_.nx, grid_.ny));
    program.set("tiles", glm::ivec2(tiles.columns(), tiles.rows()));
}

void Terrain::swap() {
    std::swap(bedrock.front, bedrock.back);
    std::swap(regolith.front, regolith.back);
}

void Terrain::settle(const gpu::Region& samples) {
    bedrock.front.copy_from(bedrock.back, samples);
    regolith.front.copy_from(regolith.back, samples);
}

void Terrain::refresh(const gpu::Region& samples) {
    bedrock.back.copy_from(bedrock.front, samples);
    regolith.back.copy_from(regolith.front, samples);
    bind(ground_program_);
    ground_program_.set("first_sample", glm::ivec2(samples.x, samples.y));
    ground_program_.dispatch((samples.width + 15) / 16, (samples.height + 15) / 16);
}

TerrainState Terrain::read() const {
    TerrainState state;
    state.grid = grid_;
    state.bedrock = bedrock.front.read_all<glm::vec2>();
    state.regolith = regolith.front.read_all<glm::vec2>();
    return state;
}

}  // namespace talus
