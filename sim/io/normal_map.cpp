#include <cmath>

#include "sim/io/export.h"
#include "sim/io/picture.h"

namespace talus::io {

void write_normal_map(const std::filesystem::path& path, const Heightmap& heightmap,
                      std::pair<int, int> across, std::pair<int, int> down) {
    const Grid& grid = heightmap.grid;
    const auto height = [&](int x, int y) {
        return static_cast<double>(
            heightmap.heights[static_cast<std::size_t>(std::clamp(y, 0, grid.ny - 1)) * grid.nx +
                              std::clamp(x, 0, grid.nx - 1)]);
    };
    std::vector<std::uint16_t> rgb;
    rgb.reserve(3 * grid.count());
    for (int y = down.first; y < down.first + down.second; ++y)
        for (int x = across.first; x < across.first + across.second; ++x) {
            // Central differences; at the edge, one-sided ones.
            const int columns = std::min(x + 1, grid.nx - 1) - std::max(x - 1, 0);
            const int rows = std::min(y + 1, grid.ny - 1) - std::max(y - 1, 0);
            const glm::dvec3 normal =
                glm::normalize(glm::dvec3(-(height(x + 1, y) - height(x - 1, y)) / (columns * grid.dx),
                                          -(height(x, y - 1) - height(x, y + 1)) / (rows * grid.dy), 1));
            for (int k = 0; k < 3; ++k)
                rgb.push_back(static_cast<std::uint16_t>(std::lround((0.5 + 0.5 * normal[k]) * 65535)));
        }
    OIIO::ImageSpec spec(across.second, down.second, 3, OIIO::TypeDesc::UINT16);
    write_encoded(path, spec, rgb.data());
}

}  // namespace talus::io
