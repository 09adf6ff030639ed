#include "sim/terrain/water_layer.h"

namespace talus {

WaterLayer::WaterLayer(const Grid& grid) {
    const auto image = [&](const char* label, gpu::Format format) {
        gpu::Texture texture(label, format, grid.nx + 2 * ghosts, grid.ny + 2 * ghosts);
        texture.fill(0);
        return texture;
    };
    front = image("water front", gpu::Format::rgba32f);
    back = image("water back", gpu::Format::rgba32f);
    bed = image("water bed", gpu::Format::r32f);
}

}  // namespace talus
