#include "sim/passes/thermal.h"

namespace talus {

Thermal::Thermal(const Terrain& terrain) : numbers_("thermal numbers"), active_(terrain.tiles.count()) {}

gpu::Program& Thermal::program_of(ThermalScheme scheme, bool wet, bool masked, bool worn) {
    const int key = (wet ? 1 : 0) + (masked ? 2 : 0) + (worn ? 4 : 0) + 8 * static_cast<int>(scheme);
    auto found = programs_.find(key);
    if (found == programs_.end()) {
        std::vector<std::string> defines;
        if (wet) defines.emplace_back("WET 1");
        if (masked) defines.emplace_back("MASKED 1");
        if (worn) defines.emplace_back("WEAR_MAP 1");
        if (scheme == ThermalScheme::olsen) defines.emplace_back("OLSEN 1");
        if (scheme == ThermalScheme::olsen_fast) defines.emplace_back("OLSEN 2");
        found = programs_.emplace(key, gpu::Program({"sim/thermal.comp"}, defines)).first;
    }
    return found->second;
}

void Thermal::substep(Terrain& terrain, const ThermalStep& step) {
    // Where nothing was painted the mask is 0, and nothing slides.
    if (step.masked && !terrain.painted) return;
    const bool wet = terrain.water && step.numbers.wet_slope != step.numbers.repose_slope;
    // All that a slope may hang on.
    const std::uint32_t changes =
        Tiles::ground | Tiles::eroded | Tiles::placed | Tiles::painted | (wet ? Tiles::water : 0U);
    terrain.tiles.list(changes, read_, -1, 1, glsl::tile_blocks, active_);
    const bool worn = step.counts_wear && terrain.worn_by_slopes;
    gpu::Program& program = program_of(step.scheme, wet, step.masked, worn);
    if (worn) program.bind_image("worn", terrain.worn_by_slopes->front);
    if (wet) program.bind_image("water", terrain.water->front);
    if (step.masked) program.bind_image("painted", terrain.painted->front);
    terrain.bind(program);
    program.bind_storage("TileList", active_.buffer);
    numbers_.set(step.numbers);
    program.bind_uniforms("ThermalNumbers", numbers_);
    program.dispatch_indirect(active_.buffer);
    gpu::barrier({gpu::Use::image, gpu::Use::sampler, gpu::Use::storage, gpu::Use::texture_transfer,
                  gpu::Use::buffer_transfer});
    terrain.swap();
}

}  // namespace talus
