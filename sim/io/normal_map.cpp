#include <cmath>

#include "sim/io/export.h"
#include "sim/io/picture.h"

namespace talus::io {

glm::dvec3 ground_normal(const Heightmap& heightmap, int column, int row) {
    const Grid& grid = heightmap.grid;
    const auto height = [&](int x, int y) {
        return static_cast<double>(
            heightmap.heights[static_cast<std::size_t>(std::clamp(y, 0, grid.ny - 1)) * grid.nx +
                              std::clamp(x, 0, grid.nx - 1)]);
    };
    const int columns = std::min(column + 1, grid.nx - 1) - std::max(column - 1, 0);
    const int rows = std::min(row + 1, grid.ny - 1) - std::max(row - 1, 0);
    return glm::normalize(
        glm::dvec3(-(height(column + 1, row) - height(column - 1, row)) / (columns * grid.dx),
                   -(height(column, row - 1) - height(column, row + 1)) / (rows * grid.dy), 1));
}

void write_normal_map(const std::filesystem::path& path, const Heightmap& heightmap,
                      std::pair<int, int> across, std::pair<int, int> down) {
    std::vector<std::uint16_t> rgb;
    rgb.reserve(3 * static_cast<std::size_t>(across.second) * down.second);
    for (int y = down.first; y < down.first + down.second; ++y)
        for (int x = across.first; x < across.first + across.second; ++x) {
            const glm::dvec3 normal = ground_normal(heightmap, x, y);
            for (int k = 0; k < 3; ++k)
                rgb.push_back(static_cast<std::uint16_t>(std::lround((0.5 + 0.5 * normal[k]) * 65535)));
        }
    OIIO::ImageSpec spec(across.second, down.second, 3, OIIO::TypeDesc::UINT16);
    write_encoded(path, spec, rgb.data());
}

}  // namespace talus::io
