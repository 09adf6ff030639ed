#include "sim/passes/mask.h"

#include <fmt/format.h>

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "sim/terrain/layers.h"

namespace talus {
namespace {

// Of which numbers of layers a mask is made, one or three; none: of the ground alone, or of no layer.
std::vector<std::string> numbers_of(MaskSource source) {
    switch (source) {
        case MaskSource::depth:
            return {"water"};
        case MaskSource::largest_depth:
            return {"depth_max"};
        case MaskSource::arrival:
            return {"arrival_s"};
        case MaskSource::flow:
            return {"flow"};
        case MaskSource::wear:
            return numbers_of_output("wear");
        case MaskSource::deposition:
            return numbers_of_output("deposition");
        case MaskSource::regolith:
            return {"regolith"};
        default:
            return {};
    }
}

// A number of a layer in its image. Bedrock and regolith share theirs.
struct ImageNumber {
    const LayerDescription* layer;
    bool two_words;
    int word;
    int texel_words;
};

ImageNumber image_number(const std::string& name) {
    const PlacedNumber number = number_named(name).value();
    const bool two_words = number.number->two_words;
    if (number.layer->is_optional()) return {number.layer, two_words, number.word, number.layer->words()};
    return {number.layer, two_words, number.layer->solid_word + number.word, 4};
}

// The layer's image; null: the terrain has none.
const gpu::Texture* image_of(const Terrain& terrain, const LayerDescription& layer) {
    if (!layer.is_optional()) return &terrain.solid.front;
    const std::optional<DeviceLayer>& image = terrain.*layer.image;
    return image ? &image->front : nullptr;
}

}  // namespace

gpu::Program& Mask::program_of(MaskSource source) {
    const auto found = programs_.find(source);
    if (found != programs_.end()) return found->second;
    std::vector<std::string> defines = {fmt::format("MASK_SOURCE {}", static_cast<int>(source))};
    const std::vector<std::string> numbers = numbers_of(source);
    if (!numbers.empty()) {
        const ImageNumber first = image_number(numbers.front());
        defines.push_back(fmt::format("LAYERS {}", numbers.size()));
        defines.emplace_back(first.texel_words == 2 ? "LAYER_FORMAT rg32f" : "LAYER_FORMAT rgba32f");
        defines.push_back(fmt::format("LAYER_GHOSTS {}", first.layer->ghosts));
        defines.push_back(fmt::format("LAYER_WORD {}", first.word));
        defines.push_back(fmt::format("LAYER_WORDS {}", first.two_words ? 2 : 1));
        defines.emplace_back(source == MaskSource::arrival ? "ABSENT_LAYER 1e30" : "ABSENT_LAYER 0");
    }
    if (source == MaskSource::arrival) defines.emplace_back("ARRIVAL 1");
    if (source == MaskSource::difference) defines.emplace_back("DIFFERENCE 1");
    gpu::Program program({"sim/mask.comp"}, defines);
    return programs_.emplace(source, std::move(program)).first->second;
}

void Mask::make(Terrain& terrain, const MaskSettings& settings) {
    const Grid& grid = terrain.grid();
    terrain.add(&Terrain::painted);
    gpu::Program& program = program_of(settings.source);
    program.bind_image("painted", terrain.painted->front);
    program.bind_image("ground", terrain.ground);
    if (settings.source == MaskSource::difference) program.bind_image("start", terrain.difference_start());
    constexpr std::array<const char*, 3> images = {"layer", "second_layer", "third_layer"};
    int layers_there = 0;
    const std::vector<std::string> numbers = numbers_of(settings.source);
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const ImageNumber number = image_number(numbers[i]);
        const gpu::Texture* image = image_of(terrain, *number.layer);
        if (image) layers_there |= 1 << i;
        const gpu::Texture& stand_in = number.texel_words == 2 ? terrain.start : terrain.solid.front;
        program.bind_image(images[i], image ? *image : stand_in);
    }
    if (!numbers.empty()) program.set("layers_there", layers_there);
    terrain.tiles.bind_for_stamping(program);
    program.set("samples", glm::ivec2(grid.nx, grid.ny));
    program.set("tiles", glm::ivec2(terrain.tiles.columns(), terrain.tiles.rows()));
    program.set("cell_m", glm::vec2(grid.dx, grid.dy));
    program.set("mask_low", static_cast<float>(settings.low));
    program.set("mask_high", static_cast<float>(settings.high));
    program.set("mask_fade", static_cast<float>(settings.fade));
    const Rectangle& edges = settings.rectangle;
    program.set("mask_rectangle", glm::vec4(grid.column_of(edges.west_m), grid.row_of(edges.north_m),
                                            grid.column_of(edges.east_m), grid.row_of(edges.south_m)));
    program.set("mask_join", static_cast<int>(settings.join));
    program.set("mask_inverted", settings.inverted ? 1 : 0);
    program.dispatch(terrain.tiles.columns(), terrain.tiles.rows());
    gpu::barrier({gpu::Use::image, gpu::Use::sampler, gpu::Use::texture_transfer, gpu::Use::storage,
                  gpu::Use::buffer_transfer});
}

}  // namespace talus
