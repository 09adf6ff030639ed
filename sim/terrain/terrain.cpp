#include "sim/terrain/terrain.h"

#include <algorithm>
#include <utility>

namespace talus {

std::vector<float> TerrainState::ground() const {
    std::vector<float> heights(bedrock.size());
    for (std::size_t i = 0; i < heights.size(); ++i)
        heights[i] = (bedrock[i].x + regolith[i].x) + (bedrock[i].y + regolith[i].y);
    return heights;
}

void drop_zero_layers(TerrainState& state) {
    const auto drop = [](auto& layer) {
        using Texel = typename std::remove_reference_t<decltype(layer)>::value_type;
        if (std::all_of(layer.begin(), layer.end(), [](const Texel& texel) { return texel == Texel(0); }))
            layer.clear();
    };
    drop(state.water);
    drop(state.inundation);
    drop(state.suspended);
    drop(state.painted);
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
    solid = {image("solid front", gpu::Format::rgba32f), image("solid back", gpu::Format::rgba32f)};
    ground = image("ground", gpu::Format::r32f);
    start = image("start", gpu::Format::rg32f);
    const gpu::Region all = ground.whole();
    std::vector<glm::vec2> words(state.bedrock.size());
    for (std::size_t i = 0; i < words.size(); ++i) {
        const glm::dvec2 sum = glm::dvec2(state.bedrock[i]) + glm::dvec2(state.regolith[i]);
        const double height = sum.x + sum.y;
        words[i].x = static_cast<float>(height);
        words[i].y = static_cast<float>(height - words[i].x);
    }
    start.write(all, std::as_bytes(std::span(words)));
    write_solid(state);
    if (!state.water.empty()) {
        add_water();
        write_water(all, state.water);
    }
    if (!state.inundation.empty()) {
        add_water();
        inundation->write(all, std::as_bytes(std::span(state.inundation)));
    }
    if (!state.suspended.empty()) {
        add_suspended();
        suspended->front.write(WaterLayer::texels(all), std::as_bytes(std::span(state.suspended)));
    }
    write_painted(state.painted);
}

void Terrain::add_water() {
    if (water) return;
    water.emplace(grid_);
    inundation.emplace("inundation", gpu::Format::rg32f, grid_.nx, grid_.ny);
    inundation->fill(0);
    tiles.mark_all();
}

void Terrain::add_suspended() {
    if (suspended) return;
    add_water();
    const auto image = [&](const char* label) {
        gpu::Texture texture(label, gpu::Format::rg32f, grid_.nx + 2 * WaterLayer::ghosts,
                             grid_.ny + 2 * WaterLayer::ghosts);
        texture.fill(0);
        return texture;
    };
    suspended = Layer{image("suspended front"), image("suspended back")};
}

void Terrain::add_painted() {
    if (painted) return;
    painted.emplace("painted", gpu::Format::rgba32f, grid_.nx, grid_.ny);
    painted->fill(0);
}

std::array<OptionalLayer, 4> Terrain::optional_layers() {
    return {OptionalLayer{water ? &water->front : nullptr, gpu::Format::rgba32f, WaterLayer::ghosts},
            OptionalLayer{inundation ? &*inundation : nullptr, gpu::Format::rg32f, 0},
            OptionalLayer{suspended ? &suspended->front : nullptr, gpu::Format::rg32f, WaterLayer::ghosts},
            OptionalLayer{painted ? &*painted : nullptr, gpu::Format::rgba32f, 0}};
}

void Terrain::write_solid(const TerrainState& state) {
    std::vector<glm::vec4> texels;
    texels.reserve(state.bedrock.size());
    for (std::size_t i = 0; i < state.bedrock.size(); ++i)
        texels.emplace_back(state.bedrock[i], state.regolith[i]);
    solid.front.write(solid.front.whole(), std::as_bytes(std::span(texels)));
    refresh(solid.front.whole());
}

void Terrain::write_painted(std::span<const glm::vec4> values) {
    if (values.empty()) return;
    add_painted();
    painted->write(painted->whole(), std::as_bytes(values));
    tiles.mark_all();
}

void Terrain::write_water(const gpu::Region& samples, std::span<const glm::vec4> values) {
    water->front.write(WaterLayer::texels(samples), std::as_bytes(values));
    tiles.mark_all();
}

void Terrain::bind(gpu::Program& program) {
    solid.front.bind_image(0, gpu::Access::read);
    solid.back.bind_image(1, gpu::Access::write);
    ground.bind_image(2, gpu::Access::write);
    tiles.bind_for_marking();
    program.set("samples", glm::ivec2(grid_.nx, grid_.ny));
    program.set("tiles", glm::ivec2(tiles.columns(), tiles.rows()));
}

void Terrain::swap() {
    std::swap(solid.front, solid.back);
}

void Terrain::settle(const gpu::Region& samples) {
    solid.front.copy_from(solid.back, samples);
}

void Terrain::refresh(const gpu::Region& samples) {
    solid.back.copy_from(solid.front, samples);
    bind(ground_program_);
    ground_program_.set("first_sample", glm::ivec2(samples.x, samples.y));
    ground_program_.dispatch((samples.width + 15) / 16, (samples.height + 15) / 16);
    gpu::barrier({gpu::Use::image, gpu::Use::sampler, gpu::Use::storage, gpu::Use::texture_transfer,
                  gpu::Use::buffer_transfer});
}

TerrainState Terrain::read() const {
    TerrainState state;
    state.grid = grid_;
    for (const glm::vec4& texel : solid.front.read_all<glm::vec4>()) {
        state.bedrock.emplace_back(texel.x, texel.y);
        state.regolith.emplace_back(texel.z, texel.w);
    }
    if (water) {
        state.water.resize(grid_.count());
        water->front.read(WaterLayer::texels({0, 0, grid_.nx, grid_.ny}),
                          std::as_writable_bytes(std::span(state.water)));
    }
    if (inundation) state.inundation = inundation->read_all<glm::vec2>();
    if (suspended) {
        state.suspended.resize(grid_.count());
        suspended->front.read(WaterLayer::texels({0, 0, grid_.nx, grid_.ny}),
                              std::as_writable_bytes(std::span(state.suspended)));
    }
    if (painted) state.painted = painted->read_all<glm::vec4>();
    drop_zero_layers(state);
    return state;
}

}  // namespace talus
