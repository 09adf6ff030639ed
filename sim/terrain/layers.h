#pragma once
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "sim/terrain/terrain_state.h"

namespace talus {

class Terrain;
struct DeviceLayer;

/// How a value of a layer is interpolated between samples when the terrain is resampled.
enum class Resampling {
    height,  ///< by cubic convolution (Keys 1981)
    amount,  ///< linearly: values that are nowhere negative stay so
    flow,    ///< linearly, and by the sample's side: half as much passes a sample of half the width
    nearest  ///< as at the nearest sample
};

/// One number of a layer's texel. A channel of the document, and an output of its own (--layer), by its name.
struct LayerNumber {
    std::string name;
    std::string unit;
    bool two_words;  ///< a high and a low float; the low one's channel is the name with `_low` behind it
    Resampling resampling;
    std::string other_name = "";  ///< of the same channel in files of other programs
};

/// Everything about a layer that does not hang on what the layer is for. A layer is an entry of `layers()`,
/// its samples in TerrainState and, unless bedrock or regolith, its image in Terrain: state, hash, undo,
/// packing, read-back, document, export and reshaping follow.
struct LayerDescription {
    /// Texels of two or of four floats.
    using Samples =
        std::variant<std::vector<glm::vec2> TerrainState::*, std::vector<glm::vec4> TerrainState::*>;

    std::string name;                  ///< as messages say it: "not written: water"
    std::vector<LayerNumber> numbers;  ///< in the order of the texel's floats; floats behind them stay 0
    Samples samples;
    /// Its image on the device; null: a part of Terrain::solid, which is always there.
    std::optional<DeviceLayer> Terrain::*image = nullptr;
    int solid_word = 0;  ///< of bedrock and regolith: the float of Terrain::solid's texel that it begins at
    int ghosts = 0;      ///< rows and columns of samples beyond each edge of the map, on the device
    bool has_back = false;  ///< passes read a front image and write a back one
    /// An image that is there wherever this one is; null: none.
    std::optional<DeviceLayer> Terrain::*needs = nullptr;
    /// What becomes of a texel where the map turns by a quarter, counterclockwise; null: it stays.
    void (*turn)(std::span<float> texel) = nullptr;
    /// What is wrong with a texel of a file, behind "'FILE' holds "; empty: nothing is. Null: all is right.
    std::string (*refusal)(std::span<const float> texel) = nullptr;

    bool is_optional() const { return image != nullptr; }
    /// Floats of a texel.
    int words() const;
};

/// All layers, in the order of the hash and of the document's channels.
const std::vector<LayerDescription>& layers();

/// A number of a layer, and at which float of its texel it begins.
struct PlacedNumber {
    const LayerDescription* layer;
    const LayerNumber* number;
    int word = 0;
};
/// The one of this name; none: there is none.
std::optional<PlacedNumber> number_named(const std::string& name);

/// Texel after texel; empty where the layer is not there.
std::span<float> words_of(TerrainState& state, const LayerDescription& layer);
std::span<const float> words_of(const TerrainState& state, const LayerDescription& layer);
/// So many texels, all of them 0. None: the layer is not there.
void make_layer(TerrainState& state, const LayerDescription& layer, std::size_t texels);

/// Names of single-layer outputs: ground, difference (of the ground from the start), level (of ground and
/// water), depth (of water), slope (degrees), curvature (1/km), wear and deposition (by all together), and
/// every number of every layer.
std::vector<std::string> output_names();
/// The numbers of layers that an output is, or is the sum of; none: it is of the ground or the level, or
/// there is no such output.
std::vector<std::string> numbers_of_output(const std::string& name);
/// Its unit; empty: it has none.
std::string output_unit(const std::string& name);
/// Its values, 0 where the layer is not there. Throws talus::Error that lists the names.
std::vector<float> output_of(const TerrainState& state, const std::string& name);

}  // namespace talus
