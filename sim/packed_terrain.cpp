#include "sim/packed_terrain.h"

#include <numeric>

namespace talus {
namespace {

PackedBytes packed_texels(const gpu::Texture& texture, const gpu::Region& region) {
    std::vector<std::byte> texels(static_cast<std::size_t>(region.width) * region.height *
                                  gpu::texel_bytes(texture.format()));
    texture.read(region, texels);
    return PackedBytes(texels);
}

}  // namespace

std::size_t PackedTerrain::bytes() const {
    return std::accumulate(optional.begin(), optional.end(), solid.bytes() + start.bytes(),
                           [](std::size_t sum, const PackedBytes& layer) { return sum + layer.bytes(); });
}

PackedTerrain pack(Terrain& terrain) {
    PackedTerrain packed;
    packed.grid = terrain.grid();
    const gpu::Region all = terrain.ground.whole();
    packed.solid = packed_texels(terrain.solid.front, all);
    packed.start = packed_texels(terrain.start, all);
    for (const OptionalLayer& layer : terrain.optional_layers())
        packed.optional.push_back(layer.front ? packed_texels(*layer.front, layer.texels(all))
                                              : PackedBytes());
    return packed;
}

Terrain unpack(const PackedTerrain& packed) {
    Terrain terrain(bedrock_terrain(packed.grid, std::vector<float>(packed.grid.count())));
    const gpu::Region all = terrain.ground.whole();
    terrain.solid.front.write(all, packed.solid.unpack());
    terrain.start.write(all, packed.start.unpack());
    terrain.refresh(all);
    const auto has = [&](std::size_t i) { return packed.optional[i].bytes() > 0; };
    if (has(0) || has(1)) terrain.add_water();
    if (has(2)) terrain.add_suspended();
    if (has(3)) terrain.add_painted();
    const auto layers = terrain.optional_layers();
    for (std::size_t i = 0; i < layers.size(); ++i)
        if (has(i)) layers[i].front->write(layers[i].texels(all), packed.optional[i].unpack());
    return terrain;
}

}  // namespace talus
