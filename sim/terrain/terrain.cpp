#include "sim/terrain/terrain.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "sim/error.h"
#include "sim/terrain/bed_beyond.h"
#include "sim/terrain/layers.h"

namespace talus {

namespace {

const LayerDescription& description_of(std::optional<DeviceLayer> Terrain::*image) {
    return *std::find_if(layers().begin(), layers().end(),
                         [&](const LayerDescription& layer) { return layer.image == image; });
}

}  // namespace

Terrain::Terrain(const TerrainState& state)
    : tiles((check_grid(state.grid), state.grid)), grid_(state.grid), ground_program_("sim/ground.comp") {
    const auto image = [&](const char* label, gpu::Format format) {
        return gpu::Texture(label, format, grid_.nx, grid_.ny);
    };
    check_bed_beyond(state);
    bed_beyond = state.bed_beyond;
    solid = {image("solid front", gpu::Format::rgba32f), image("solid back", gpu::Format::rgba32f)};
    ground = image("ground", gpu::Format::r32f);
    start = image("start", gpu::Format::rg32f);
    const gpu::Region all = ground.whole();
    const std::vector<glm::vec2> words = state.ground_words();
    start.write(all, std::as_bytes(std::span(words)));
    if (!state.start.empty() && state.start != words) {
        if (state.start.size() != words.size())
            throw Error(fmt::format("the start that a difference counts from has {} samples, it must have {}",
                                    state.start.size(), words.size()));
        earlier_start = image("earlier start", gpu::Format::rg32f);
        earlier_start->write(all, std::as_bytes(std::span(state.start)));
    }
    write_solid(state);
    for (const LayerDescription& layer : layers())
        if (layer.is_optional()) write(layer.image, state);
}

void Terrain::add(std::optional<DeviceLayer> Terrain::*image) {
    if (this->*image) return;
    const LayerDescription& layer = description_of(image);
    const auto texture = [&](const std::string& label, gpu::Format format) {
        gpu::Texture made(label, format, grid_.nx + 2 * layer.ghosts, grid_.ny + 2 * layer.ghosts);
        made.fill(0);
        return made;
    };
    const gpu::Format format = layer.words() == 2 ? gpu::Format::rg32f : gpu::Format::rgba32f;
    DeviceLayer& added = (this->*image).emplace();
    added.ghosts = layer.ghosts;
    added.front = texture(layer.name + " front", format);
    if (layer.has_back) added.back = texture(layer.name + " back", format);
    if (image == &Terrain::water) water_bed = texture("water bed", gpu::Format::r32f);
    if (layer.needs) add(layer.needs);
    tiles.mark_all();
}

void Terrain::write_solid(const TerrainState& state) {
    std::vector<glm::vec4> texels;
    texels.reserve(state.bedrock.size());
    for (std::size_t i = 0; i < state.bedrock.size(); ++i)
        texels.emplace_back(state.bedrock[i], state.regolith[i]);
    solid.front.write(solid.front.whole(), std::as_bytes(std::span(texels)));
    refresh(solid.front.whole());
}

void Terrain::write(std::optional<DeviceLayer> Terrain::*image, const TerrainState& state) {
    const std::span<const float> words = words_of(state, description_of(image));
    if (words.empty()) return;
    add(image);
    DeviceLayer& layer = *(this->*image);
    layer.front.write(layer.texels(ground.whole()), std::as_bytes(words));
    for (std::size_t i = 0; i < painted_number_count; ++i) {
        const PaintedNumberDescription& number = painted_numbers()[i];
        if (number.layer().image == image) ever_painted[i] = ever_painted[i] || is_painted(number, words);
    }
    tiles.mark_all();
}

void Terrain::bind(gpu::Program& program) {
    program.bind_image("solid_in", solid.front);
    program.bind_image("solid_out", solid.back);
    program.bind_image("ground_out", ground);
    tiles.bind_for_stamping(program);
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
    state.bed_beyond = bed_beyond;
    for (const glm::vec4& texel : solid.front.read_all<glm::vec4>()) {
        state.bedrock.emplace_back(texel.x, texel.y);
        state.regolith.emplace_back(texel.z, texel.w);
    }
    for (const LayerDescription& layer : layers()) read(layer, state);
    drop_zero_layers(state);
    state.start = difference_start().read_all<glm::vec2>();
    return state;
}

void Terrain::read(const LayerDescription& layer, TerrainState& state) const {
    if (!layer.is_optional() || !(this->*layer.image)) return;
    const DeviceLayer& image = *(this->*layer.image);
    make_layer(state, layer, grid_.count());
    image.front.read(image.texels(ground.whole()), std::as_writable_bytes(words_of(state, layer)));
}

}  // namespace talus
