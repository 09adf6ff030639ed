#include "sim/passes/sediment.h"

namespace talus {

Sediment::Sediment(const Grid& grid)
    : edge_books("sediment edge books", 2 * static_cast<std::size_t>(grid.nx + grid.ny) * sizeof(glm::dvec2)),
      bed_program_("sim/sediment_bed.comp") {
    edge_books.fill(0);
}

Book Sediment::book() {
    return {"sediment edges", &edge_books,
            [](const gpu::Buffer& words, const Grid& grid, const SolidWeights&, BudgetTerms& terms) {
                const double area_m2 = grid.dx * grid.dy;
                glm::dvec2 metres(0);
                for (const glm::dvec2& sample : words.read_all<glm::dvec2>()) metres += sample;
                terms.solid_edges_in_m3 += metres.x * area_m2;
                terms.solid_edges_out_m3 += metres.y * area_m2;
            }};
}

gpu::Program& Sediment::program_of(bool painted, bool worn, bool land_cover) {
    const std::array<bool, 3> wanted = {painted, worn, land_cover};
    const auto found = programs_.find(wanted);
    if (found != programs_.end()) return found->second;
    std::vector<std::string> defines;
    if (painted) defines.emplace_back("PAINTED 1");
    if (worn) defines.emplace_back("WEAR_MAP 1");
    if (land_cover) defines.emplace_back("LAND_COVER 1");
    gpu::Program program({"sim/sediment.comp"}, defines);
    return programs_.emplace(wanted, std::move(program)).first->second;
}

void Sediment::exchange(Terrain& terrain, const gpu::Buffer& list, const gpu::Buffer& activity,
                        const gpu::Buffer& clock, const gpu::Buffer& tick, SedimentMaps maps) {
    const bool worn = maps.wear && terrain.worn_by_water;
    gpu::Program& program = program_of(terrain.painted.has_value(), worn, maps.land_cover);
    if (maps.land_cover) program.bind_image("land_cover", terrain.land_cover->front);
    if (worn) program.bind_image("worn", terrain.worn_by_water->front);
    program.bind_image("water_in", terrain.water->front);
    program.bind_image("load", terrain.suspended->front);
    program.bind_image("bed", terrain.water_bed);
    if (terrain.painted) program.bind_image("painted", terrain.painted->front);
    program.bind_image("solid", terrain.solid.front);
    program.bind_image("ground", terrain.ground);
    program.bind_storage("TileList", list);
    program.bind_storage("WaterActivity", activity);
    program.bind_storage("WaterClock", clock);
    program.bind_uniforms("WaterNumbers", tick);
    program.bind_uniforms("SedimentNumbers", numbers);
    terrain.tiles.bind_for_stamping(program);
    program.dispatch_indirect(list);
    gpu::barrier({gpu::Use::image, gpu::Use::sampler, gpu::Use::storage, gpu::Use::texture_transfer,
                  gpu::Use::buffer_transfer});

    bed_program_.bind_image("ground", terrain.ground);
    bed_program_.bind_image("bed", terrain.water_bed);
    bed_program_.bind_storage("TileList", list);
    bed_program_.bind_storage("WaterClock", clock);
    bed_program_.bind_uniforms("WaterNumbers", tick);
    bed_program_.dispatch_indirect(list);
    gpu::barrier({gpu::Use::image, gpu::Use::sampler, gpu::Use::texture_transfer, gpu::Use::storage,
                  gpu::Use::buffer_transfer});
}

}  // namespace talus
