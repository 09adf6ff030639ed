#pragma once
#include "sim/terrain/terrain.h"

namespace talus {

/// The terrain resampled over the same extent. Bedrock is interpolated by cubic convolution (Keys 1981,
/// a = -1/2), other layers linearly, so that no amount becomes negative, arrival times from the nearest
/// sample. When samples get fewer, both kernels are widened against aliasing. An unchanged number of samples
/// keeps all bits, and only then is the ground beyond the edges still known. Throws talus::Error when the
/// grid cannot be used.
TerrainState resampled(const TerrainState& state, int nx, int ny);

/// A rectangle in metres from the south-west sample, moved outwards to whole samples.
struct Rectangle {
    double west_m = 0;
    double south_m = 0;
    double east_m = 0;
    double north_m = 0;
    bool operator==(const Rectangle&) const = default;
};

/// The samples in the rectangle, cut at the terrain's edge, to the bit. Springs outside go. Where the ground
/// beyond the edges is known, what is cut off becomes a part of it. Throws talus::Error when fewer than two
/// samples a side are left.
TerrainState cropped(const TerrainState& state, const Rectangle& rectangle);

/// The terrain turned by quarters of a circle, counterclockwise, to the bit; currents, springs and the ground
/// beyond the edges turn with it. It lies nowhere on Earth any more.
TerrainState turned(const TerrainState& state, int quarters);

/// The samples of a grid in the rectangle, cut at its edge.
gpu::Region samples_in(const Grid& grid, const Rectangle& rectangle);

}  // namespace talus
