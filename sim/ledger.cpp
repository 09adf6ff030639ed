#include "sim/ledger.h"

#include <cmath>

namespace talus {

double LedgerReading::closing_error_of_moved() const {
    const double error = std::abs(closing_error_m3());
    return error == 0 ? 0 : error / moved_m3;
}

Ledger::Ledger(const Terrain& terrain)
    : program_("sim/ledger.comp"),
      tile_sums_("ledger sums", static_cast<std::size_t>(terrain.tiles.count()) * 2 * sizeof(double)) {
    initial_ = sum(terrain).x;
}

glm::dvec2 Ledger::sum(const Terrain& terrain) {
    terrain.solid.front.bind_image(0, gpu::Access::read);
    terrain.start.bind_image(1, gpu::Access::read);
    tile_sums_.bind_storage(0);
    program_.set("samples", glm::ivec2(terrain.grid().nx, terrain.grid().ny));
    program_.set("tiles", glm::ivec2(terrain.tiles.columns(), terrain.tiles.rows()));
    program_.dispatch(terrain.tiles.columns(), terrain.tiles.rows());
    glm::dvec2 total(0);
    for (const glm::dvec2& tile : tile_sums_.read_all<glm::dvec2>()) total += tile;
    return total * (terrain.grid().dx * terrain.grid().dy);
}

LedgerReading Ledger::read(const Terrain& terrain, const Brush& brush) {
    const double area = terrain.grid().dx * terrain.grid().dy;
    const glm::dvec2 now = sum(terrain);
    LedgerReading reading;
    reading.solid_initial = initial_;
    reading.solid_final = now.x;
    reading.moved_m3 = now.y / 2;
    for (const glm::dvec2& book : brush.books.read_all<glm::dvec2>()) {
        reading.solid_in += book.x * area;
        reading.solid_out += book.y * area;
    }
    return reading;
}

}  // namespace talus
