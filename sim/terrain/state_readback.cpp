#include "sim/terrain/state_readback.h"

#include <cstring>
#include <utility>

namespace talus {
namespace {

template <typename Texel>
void take(const std::vector<float>& words, std::vector<Texel>& layer) {
    layer.resize(words.size() * sizeof(float) / sizeof(Texel));
    std::memcpy(layer.data(), words.data(), words.size() * sizeof(float));
}

}  // namespace

void StateReadback::start(const Terrain& terrain) {
    state_.emplace();
    state_->grid = terrain.grid();
    const gpu::Region all = terrain.ground.whole();
    layers_[0].start(terrain.solid.front, all);
    if (terrain.water) layers_[1].start(terrain.water->front, WaterLayer::texels(all));
    if (terrain.inundation) layers_[2].start(*terrain.inundation, all);
    if (terrain.suspended) layers_[3].start(terrain.suspended->front, WaterLayer::texels(all));
    if (terrain.painted) layers_[4].start(*terrain.painted, all);
}

std::optional<TerrainState> StateReadback::poll() {
    if (!state_) return std::nullopt;
    for (std::size_t i = 0; i < layers_.size(); ++i) {
        if (!layers_[i].pending()) continue;
        const auto words = layers_[i].poll();
        if (!words) return std::nullopt;
        if (i == 0) {
            state_->bedrock.reserve(words->size() / 4);
            state_->regolith.reserve(words->size() / 4);
            for (std::size_t k = 0; k < words->size(); k += 4) {
                state_->bedrock.emplace_back((*words)[k], (*words)[k + 1]);
                state_->regolith.emplace_back((*words)[k + 2], (*words)[k + 3]);
            }
        }
        if (i == 1) take(*words, state_->water);
        if (i == 2) take(*words, state_->inundation);
        if (i == 3) take(*words, state_->suspended);
        if (i == 4) take(*words, state_->painted);
        // The others in the next frames.
        return std::nullopt;
    }
    std::optional<TerrainState> read = std::move(state_);
    state_.reset();
    drop_zero_layers(*read);
    return read;
}

void StateReadback::cancel() {
    for (gpu::Readback& layer : layers_) layer.cancel();
    state_.reset();
}

}  // namespace talus
