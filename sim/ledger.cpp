#include "sim/ledger.h"

#include <cmath>

#include "sim/passes/sediment_step.h"

namespace talus {
namespace {

double error_of(double error, double of) {
    return error == 0 ? 0 : std::abs(error) / of;
}

// m³ of each, regolith and suspended without their weights.
struct Sums {
    double bedrock = 0;
    double regolith = 0;
    double suspended = 0;
    double water = 0;
    double eroded = 0;
    double deposited = 0;
    double solid(const SolidWeights& weights) const {
        return bedrock + weights.regolith * regolith + weights.suspended * suspended;
    }
};

Sums sums_of(const std::vector<glm::dvec4>& tiles, double area_m2) {
    glm::dvec4 stores(0);
    glm::dvec4 changes(0);
    for (std::size_t tile = 0; tile < tiles.size(); tile += 2) {
        stores += tiles[tile];
        changes += tiles[tile + 1];
    }
    stores *= area_m2;
    changes *= area_m2;
    return {stores.x, stores.y, stores.z, stores.w, changes.x, changes.y};
}

}  // namespace

SolidWeights solid_weights(const Parameters& parameters) {
    const SedimentSettings settings = sediment_settings(parameters);
    return {1 / static_cast<double>(bulking_of(settings.porosity)),
            static_cast<double>(static_cast<float>(settings.acceleration))};
}

double LedgerReading::closing_error_of_moved() const {
    return error_of(closing_error_m3(), moved_m3());
}

double LedgerReading::closing_error_of_eroded() const {
    return error_of(closing_error_m3(), eroded_m3);
}

Ledger::Ledger(const Terrain& terrain)
    : area_m2_(terrain.grid().dx * terrain.grid().dy),
      program_("sim/ledger.comp"),
      tile_sums_("ledger sums", static_cast<std::size_t>(terrain.tiles.count()) * 2 * sizeof(glm::dvec4)),
      water_program_({"sim/ledger.comp"}, {"WATER 1"}),
      loaded_program_({"sim/ledger.comp"}, {"WATER 1", "SEDIMENT 1"}) {}

LedgerStart Ledger::begin(const Terrain& terrain, const SolidWeights& weights) {
    sum(terrain);
    const Sums now = sums_of(tile_sums_.read_all<glm::dvec4>(), area_m2_);
    return {now.solid(weights), now.water};
}

void Ledger::sum(const Terrain& terrain) {
    gpu::Program& program = terrain.suspended ? loaded_program_ : terrain.water ? water_program_ : program_;
    program.bind_image("solid_in", terrain.solid.front);
    program.bind_image("start_in", terrain.start);
    if (terrain.water) program.bind_image("water_in", terrain.water->front);
    if (terrain.suspended) program.bind_image("load_in", terrain.suspended->front);
    program.bind_storage("TileSums", tile_sums_);
    program.set("samples", glm::ivec2(terrain.grid().nx, terrain.grid().ny));
    program.set("tiles", glm::ivec2(terrain.tiles.columns(), terrain.tiles.rows()));
    program.dispatch(terrain.tiles.columns(), terrain.tiles.rows());
    gpu::barrier({gpu::Use::buffer_transfer, gpu::Use::storage});
}

LedgerReading Ledger::reading(const LedgerStart& start, const std::vector<glm::dvec4>& tile_sums,
                              const SolidWeights& weights, const BudgetTerms& terms) const {
    const Sums now = sums_of(tile_sums, area_m2_);
    LedgerReading reading;
    reading.bedrock = now.bedrock;
    reading.regolith = weights.regolith * now.regolith;
    reading.suspended = weights.suspended * now.suspended;
    reading.solid_initial = start.solid_m3;
    reading.solid_final = now.solid(weights);
    reading.eroded_m3 = now.eroded;
    reading.deposited_m3 = now.deposited;
    reading.solid_in = terms.solid_in_m3 + terms.solid_edges_in_m3;
    reading.solid_edges_out = terms.solid_edges_out_m3;
    reading.solid_out = terms.solid_out_m3 + terms.solid_edges_out_m3;
    reading.water_initial = start.water_m3;
    reading.water_final = now.water;
    reading.water_in = terms.water.in_m3();
    reading.water_out = terms.water.out_m3();
    return reading;
}

}  // namespace talus
