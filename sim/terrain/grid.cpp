#include "sim/terrain/grid.h"

#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <string>

#include "sim/error.h"

namespace talus {
namespace {

// Layers (4 x 8 bytes), ground and start (12), pyramid (under 4), and a copy of the layers on its way in or
// out (16).
constexpr double bytes_per_sample = 100;

double available_bytes() {
    std::ifstream file("/proc/meminfo");
    std::string name;
    double kib = 0;
    std::string unit;
    while (file >> name >> kib) {
        std::getline(file, unit);
        if (name == "MemAvailable:") return kib * 1024;
    }
    return HUGE_VAL;
}

}  // namespace

void check_grid(const Grid& grid) {
    if (!is_terrain_size(grid.nx, grid.ny))
        throw Error(
            fmt::format("a terrain of {} x {} samples cannot be used, each side must have {} to {} samples",
                        grid.nx, grid.ny, min_samples, max_samples));
    if (!(grid.dx > 0) || !(grid.dy > 0) || !std::isfinite(grid.dx) || !std::isfinite(grid.dy))
        throw Error(
            fmt::format("a spacing of {} x {} m cannot be used, it must be positive", grid.dx, grid.dy));
    const double needed = bytes_per_sample * static_cast<double>(grid.count());
    if (needed > 0.9 * available_bytes())
        throw Error(
            fmt::format("a terrain of {} x {} samples needs about {:.1f} GiB where {:.1f} GiB are free, use "
                        "a smaller --size",
                        grid.nx, grid.ny, needed / 1073741824.0, available_bytes() / 1073741824.0));
}

}  // namespace talus
