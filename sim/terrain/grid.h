#pragma once
#include <cstddef>

namespace talus {

/// The smallest and the largest number of samples in a row or a column.
constexpr int min_samples = 2;
constexpr int max_samples = 8192;
/// Whether a terrain may have so many in a row and in a column.
constexpr bool is_terrain_size(int nx, int ny) {
    return nx >= min_samples && ny >= min_samples && nx <= max_samples && ny <= max_samples;
}

namespace glsl {
#include "sim/tile_samples.glsl"
}

/// Samples of a tile in a row and in a column: the one unit of dirtiness, activity and undo.
constexpr int tile_samples = glsl::tile_samples;

/// Where the samples lie: nx columns (west to east) by ny rows (row 0 is the north row), spacing in metres.
/// The south-west sample is at world (0, 0).
struct Grid {
    int nx = 0;
    int ny = 0;
    double dx = 1;
    double dy = 1;

    std::size_t count() const { return static_cast<std::size_t>(nx) * static_cast<std::size_t>(ny); }
    double width_m() const { return (nx - 1) * dx; }
    double height_m() const { return (ny - 1) * dy; }
    double column_of(double x_m) const { return x_m / dx; }
    double row_of(double y_m) const { return (ny - 1) - y_m / dy; }
    bool operator==(const Grid&) const = default;
};

/// Throws talus::Error when a side is outside of 2 to 8192, a spacing is not positive and finite, or the
/// machine has not the memory that the simulation and the picture of such a terrain take.
void check_grid(const Grid& grid);

}  // namespace talus
