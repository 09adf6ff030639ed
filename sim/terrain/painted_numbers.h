#pragma once
#include <array>
#include <span>
#include <string>
#include <vector>

namespace talus {

struct LayerDescription;
struct TerrainState;

/// Numbers of layers that brushes paint and rasters bring: hardness and mask, 0 to 1, rain, mm/h, Manning's
/// n, s/m^(1/3), and infiltration, mm/h.
enum class PaintedNumber { hardness, mask, rain, manning, infiltration };
constexpr std::size_t painted_number_count = 5;

/// One of them, with its place in a layer.
struct PaintedNumberDescription {
    std::string name;   ///< of the number in its layer, and of a dab's material
    std::string title;  ///< in panels
    double most;        ///< the smallest is 0
    /// The layer holds the number times its share, and the share behind it: how far it holds in place of a
    /// parameter (shaders/maths/land_cover.glsl).
    bool has_share = false;

    const LayerDescription& layer() const;
    int word() const;  ///< of the layer's texel, at which it begins
};

/// All of them, in the order of PaintedNumber.
const std::vector<PaintedNumberDescription>& painted_numbers();
const PaintedNumberDescription& description_of(PaintedNumber number);
/// The one of this name. Throws talus::Error that lists the names.
const PaintedNumberDescription& painted_number_named(const std::string& name);

/// The number becomes these values, one a sample, where they are not NaN, and holds there alone. Throws
/// talus::Error, a predicate such as "holds a manning of 35, it must be 0 to 1", with nothing changed.
void take_values(TerrainState& state, const PaintedNumberDescription& number,
                 const std::vector<float>& values);

/// Whether a number was painted at a sample of its layer's words; floats of all texels.
bool is_painted(const PaintedNumberDescription& number, std::span<const float> words);

}  // namespace talus
