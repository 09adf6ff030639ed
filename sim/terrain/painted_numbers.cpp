#include "sim/terrain/painted_numbers.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "sim/error.h"
#include "sim/terrain/layers.h"

namespace talus {

const LayerDescription& PaintedNumberDescription::layer() const {
    return *number_named(name)->layer;
}

int PaintedNumberDescription::word() const {
    return number_named(name)->word;
}

const std::vector<PaintedNumberDescription>& painted_numbers() {
    static const std::vector<PaintedNumberDescription> all = {
        {.name = "hardness", .title = "Hardness", .most = 1},
        {.name = "mask", .title = "Mask", .most = 1},
        {.name = "rain", .title = "Rain", .most = 1e4},
        {.name = "manning", .title = "Manning's n", .most = 1, .has_share = true},
        {.name = "infiltration", .title = "Infiltration", .most = 1e4, .has_share = true}};
    return all;
}

const PaintedNumberDescription& description_of(PaintedNumber number) {
    return painted_numbers()[static_cast<std::size_t>(number)];
}

const PaintedNumberDescription& painted_number_named(const std::string& name) {
    const auto found = std::find_if(painted_numbers().begin(), painted_numbers().end(),
                                    [&](const PaintedNumberDescription& one) { return one.name == name; });
    if (found != painted_numbers().end()) return *found;
    std::vector<std::string> names;
    for (const PaintedNumberDescription& one : painted_numbers()) names.push_back(one.name);
    throw Error(fmt::format("'{}' is not a number that is painted, it must be one of: {}", name,
                            fmt::join(names, ", ")));
}

void take_values(TerrainState& state, const PaintedNumberDescription& number,
                 const std::vector<float>& values) {
    if (values.size() != state.grid.count())
        throw Error(fmt::format("holds {} numbers where the terrain has {} samples", values.size(),
                                state.grid.count()));
    for (const float value : values)
        if (value < 0 || value > number.most)
            throw Error(fmt::format("holds a {} of {}, it must be 0 to {}", number.name, value, number.most));
    const LayerDescription& layer = number.layer();
    if (words_of(state, layer).empty()) make_layer(state, layer, state.grid.count());
    const std::span<float> words = words_of(state, layer);
    const auto texel = static_cast<std::size_t>(layer.words());
    auto at = static_cast<std::size_t>(number.word());
    for (std::size_t i = 0; i < values.size(); ++i, at += texel) {
        if (std::isnan(values[i])) continue;
        words[at] = values[i];
        if (number.has_share) words[at + 1] = 1;
    }
}

bool is_painted(const PaintedNumberDescription& number, std::span<const float> words) {
    const auto texel = static_cast<std::size_t>(number.layer().words());
    auto at = static_cast<std::size_t>(number.word()) + (number.has_share ? 1U : 0U);
    for (; at < words.size(); at += texel)
        if (words[at] > 0) return true;
    return false;
}

}  // namespace talus
