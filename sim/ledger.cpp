#include "sim/ledger.h"

#include <cmath>

namespace talus {

double LedgerReading::closing_error_of_moved() const {
    const double error = std::abs(closing_error_m3());
    return error == 0 ? 0 : error / moved_m3;
}

Ledger::Ledger(const Terrain& terrain)
    : program_("sim/ledger.comp"),
      tile_sums_("ledger sums", static_cast<std::size_t>(terrain.tiles.count()) * sizeof(glm::dvec4)),
      water_program_({"sim/ledger.comp"}, {"WATER 1"}) {
    initial_ = sum(terrain);
}

glm::dvec3 Ledger::sum(const Terrain& terrain) {
    gpu::Program& program = terrain.water ? water_program_ : program_;
    terrain.solid.front.bind_image(0, gpu::Access::read);
    terrain.start.bind_image(1, gpu::Access::read);
    if (terrain.water) terrain.water->front.bind_image(2, gpu::Access::read);
    tile_sums_.bind_storage(0);
    program.set("samples", glm::ivec2(terrain.grid().nx, terrain.grid().ny));
    program.set("tiles", glm::ivec2(terrain.tiles.columns(), terrain.tiles.rows()));
    program.dispatch(terrain.tiles.columns(), terrain.tiles.rows());
    glm::dvec3 total(0);
    for (const glm::dvec4& tile : tile_sums_.read_all<glm::dvec4>()) total += glm::dvec3(tile);
    return total * (terrain.grid().dx * terrain.grid().dy);
}

LedgerReading Ledger::read(const Terrain& terrain, const Brush& brush, const WaterBooks& water) {
    const double area = terrain.grid().dx * terrain.grid().dy;
    const glm::dvec3 now = sum(terrain);
    LedgerReading reading;
    reading.solid_initial = initial_.x;
    reading.solid_final = now.x;
    reading.moved_m3 = now.y / 2;
    for (const glm::dvec2& book : brush.books.read_all<glm::dvec2>()) {
        reading.solid_in += book.x * area;
        reading.solid_out += book.y * area;
    }
    reading.water_initial = initial_.z;
    reading.water_final = now.z;
    reading.water_in = water.in_m3();
    reading.water_out = water.out_m3();
    return reading;
}

}  // namespace talus
