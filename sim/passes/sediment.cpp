#include "sim/passes/sediment.h"

namespace talus {

float bulking_of(double porosity) {
    return static_cast<float>(1 / (1 - porosity));
}

SedimentStep sediment_step(const SedimentSettings& settings, double gravity_m_per_s2, double manning) {
    constexpr double water_kg_per_m3 = 1000;
    SedimentStep step;
    step.drag = static_cast<float>(water_kg_per_m3 * gravity_m_per_s2 * manning * manning);
    step.critical = static_cast<float>(settings.critical_pa);
    step.regolith = static_cast<float>(settings.regolith_m_per_s_pa);
    step.bedrock = static_cast<float>(settings.bedrock_m_per_s_pa);
    step.settling = static_cast<float>(settings.settling_m_per_s);
    step.speedup = static_cast<float>(settings.acceleration);
    step.bulking = bulking_of(settings.porosity);
    step.per_rock = 1 / step.speedup;
    step.per_loose = 1 / (step.speedup * step.bulking);
    step.masked = settings.masked ? 1 : 0;
    step.below = settings.below_neighbours ? 1 : 0;
    step.strata = glm::vec2(settings.strata_m, settings.strata_hardness);
    return step;
}

Sediment::Sediment(const Grid& grid)
    : edge_books("sediment edge books", 2 * static_cast<std::size_t>(grid.nx + grid.ny) * sizeof(glm::dvec2)),
      program_("sim/sediment.comp"),
      painted_program_({"sim/sediment.comp"}, {"PAINTED 1"}),
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

void Sediment::exchange(Terrain& terrain, const SedimentStep& step, double gravity_m_per_s2, int eulers,
                        const gpu::Buffer& list, const gpu::Buffer& activity, const gpu::Buffer& clock) {
    gpu::Program& program = terrain.painted ? painted_program_ : program_;
    program.bind_image("water_in", terrain.water->front);
    program.bind_image("load", terrain.suspended->front);
    program.bind_image("bed", terrain.water_bed);
    if (terrain.painted) program.bind_image("painted", terrain.painted->front);
    program.bind_image("solid", terrain.solid.front);
    program.bind_image("ground", terrain.ground);
    program.bind_storage("TileList", list);
    program.bind_storage("WaterActivity", activity);
    program.bind_storage("WaterClock", clock);
    terrain.tiles.bind_for_stamping(program);
    program.set("samples", glm::ivec2(terrain.grid().nx, terrain.grid().ny));
    program.set("tiles", glm::ivec2(terrain.tiles.columns(), terrain.tiles.rows()));
    program.set("gravity", static_cast<float>(gravity_m_per_s2));
    program.set("eulers", eulers);
    program.set("sediment_drag", step.drag);
    program.set("sediment_critical", step.critical);
    program.set("sediment_regolith", step.regolith);
    program.set("sediment_bedrock", step.bedrock);
    program.set("sediment_settling", step.settling);
    program.set("sediment_speedup", step.speedup);
    program.set("sediment_bulking", step.bulking);
    program.set("sediment_per_rock", step.per_rock);
    program.set("sediment_per_loose", step.per_loose);
    program.set("sediment_strata", step.strata);
    program.set("sediment_masked", step.masked);
    program.set("sediment_below", step.below);
    program.dispatch_indirect(list);
    gpu::barrier({gpu::Use::image, gpu::Use::sampler, gpu::Use::storage, gpu::Use::texture_transfer,
                  gpu::Use::buffer_transfer});

    bed_program_.bind_image("ground", terrain.ground);
    bed_program_.bind_image("bed", terrain.water_bed);
    bed_program_.bind_storage("TileList", list);
    bed_program_.bind_storage("WaterClock", clock);
    bed_program_.set("samples", glm::ivec2(terrain.grid().nx, terrain.grid().ny));
    bed_program_.set("tiles", glm::ivec2(terrain.tiles.columns(), terrain.tiles.rows()));
    bed_program_.dispatch_indirect(list);
    gpu::barrier({gpu::Use::image, gpu::Use::sampler, gpu::Use::texture_transfer, gpu::Use::storage,
                  gpu::Use::buffer_transfer});
}

}  // namespace talus
