#include "sim/terrain/state_readback.h"

#include <algorithm>
#include <utility>

#include "sim/terrain/layers.h"

namespace talus {
void StateReadback::start(const Terrain& terrain) {
    state_.emplace();
    state_->grid = terrain.grid();
    state_->bed_beyond = terrain.bed_beyond;
    const gpu::Region all = terrain.ground.whole();
    solid_.start(terrain.solid.front, all);
    start_.start(terrain.difference_start(), all);
    layers_.resize(layers().size());
    for (std::size_t i = 0; i < layers_.size(); ++i) {
        const LayerDescription& layer = layers()[i];
        if (!layer.is_optional() || !(terrain.*layer.image)) continue;
        const DeviceLayer& image = *(terrain.*layer.image);
        layers_[i].start(image.front, image.texels(all));
    }
}

std::optional<TerrainState> StateReadback::poll() {
    if (!state_) return std::nullopt;
    // One layer a frame.
    if (solid_.pending()) {
        const auto words = solid_.poll();
        for (std::size_t k = 0; words && k < words->size(); k += 4) {
            state_->bedrock.emplace_back((*words)[k], (*words)[k + 1]);
            state_->regolith.emplace_back((*words)[k + 2], (*words)[k + 3]);
        }
        return std::nullopt;
    }
    if (start_.pending()) {
        const auto words = start_.poll();
        for (std::size_t k = 0; words && k < words->size(); k += 2)
            state_->start.emplace_back((*words)[k], (*words)[k + 1]);
        return std::nullopt;
    }
    for (std::size_t i = 0; i < layers_.size(); ++i) {
        if (!layers_[i].pending()) continue;
        if (const auto words = layers_[i].poll()) {
            make_layer(*state_, layers()[i], state_->grid.count());
            std::copy(words->begin(), words->end(), words_of(*state_, layers()[i]).begin());
        }
        return std::nullopt;
    }
    std::optional<TerrainState> read = std::move(state_);
    state_.reset();
    drop_zero_layers(*read);
    return read;
}

void StateReadback::cancel() {
    solid_.cancel();
    start_.cancel();
    for (gpu::Readback& layer : layers_) layer.cancel();
    state_.reset();
}

}  // namespace talus
