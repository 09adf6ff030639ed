#include "sim/packed_terrain.h"

#include <numeric>

#include "sim/terrain/layers.h"

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
    const std::size_t always =
        solid.bytes() + start.bytes() + earlier_start.bytes() + bed_beyond.size() * sizeof(float);
    return std::accumulate(optional.begin(), optional.end(), always,
                           [](std::size_t sum, const PackedBytes& layer) { return sum + layer.bytes(); });
}

PackedTerrain pack(const Terrain& terrain) {
    PackedTerrain packed;
    packed.grid = terrain.grid();
    packed.bed_beyond = terrain.bed_beyond;
    packed.ever_painted = terrain.ever_painted;
    const gpu::Region all = terrain.ground.whole();
    packed.solid = packed_texels(terrain.solid.front, all);
    packed.start = packed_texels(terrain.start, all);
    if (terrain.earlier_start) packed.earlier_start = packed_texels(*terrain.earlier_start, all);
    for (const LayerDescription& layer : layers()) {
        const DeviceLayer* image =
            layer.is_optional() && terrain.*layer.image ? &*(terrain.*layer.image) : nullptr;
        packed.optional.push_back(image ? packed_texels(image->front, image->texels(all)) : PackedBytes());
    }
    return packed;
}

Terrain unpack(const PackedTerrain& packed) {
    TerrainState flat = bedrock_terrain(packed.grid, std::vector<float>(packed.grid.count()));
    flat.bed_beyond = packed.bed_beyond;
    Terrain terrain(flat);
    const gpu::Region all = terrain.ground.whole();
    terrain.solid.front.write(all, packed.solid.unpack());
    terrain.start.write(all, packed.start.unpack());
    if (packed.earlier_start.bytes() > 0) {
        terrain.earlier_start =
            gpu::Texture("earlier start", gpu::Format::rg32f, packed.grid.nx, packed.grid.ny);
        terrain.earlier_start->write(all, packed.earlier_start.unpack());
    }
    terrain.refresh(all);
    for (std::size_t i = 0; i < layers().size(); ++i) {
        if (packed.optional[i].bytes() == 0) continue;
        terrain.add(layers()[i].image);
        DeviceLayer& image = *(terrain.*layers()[i].image);
        image.front.write(image.texels(all), packed.optional[i].unpack());
    }
    terrain.ever_painted = packed.ever_painted;
    return terrain;
}

}  // namespace talus
