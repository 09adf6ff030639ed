#include "sim/passes/brush.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sim/gpu/error.h"

namespace talus {

void check_dab(const Dab& dab) {
    const struct {
        const char* name;
        double value;
        double low;
        double high;
    } fields[] = {{"x_m", dab.x_m, -1e9, 1e9},
                  {"y_m", dab.y_m, -1e9, 1e9},
                  {"radius_m", dab.radius_m, 1e-6, 1e9},
                  {"falloff", dab.falloff, 0, 1},
                  {"blend", dab.blend, 0, 1},
                  {"amount_m", dab.amount_m, 0, 1e6},
                  {"target_m", dab.target_m, -1e6, 1e6}};
    for (const auto& field : fields)
        if (!(field.value >= field.low && field.value <= field.high))
            throw Error(fmt::format("a dab's {} cannot be {}, it must be {} to {}", field.name, field.value,
                                    field.low, field.high));
}

DabStep dab_step(const Grid& grid, const Dab& dab) {
    const double column = grid.column_of(dab.x_m);
    const double row = grid.row_of(dab.y_m);
    DabStep step;
    step.cell_m = glm::vec2(grid.dx, grid.dy);
    step.sample = glm::ivec2(std::floor(column), std::floor(row));
    step.offset = glm::vec2(column - std::floor(column), row - std::floor(row));
    step.radius_m = static_cast<float>(dab.radius_m);
    step.falloff = static_cast<float>(dab.falloff);
    step.mode = static_cast<int>(dab.mode);
    step.amount_m = static_cast<float>(dab.amount_m);
    step.blend = static_cast<float>(std::clamp(dab.blend, 0.0, 1.0));
    step.target_m.x = static_cast<float>(dab.target_m);
    step.target_m.y = static_cast<float>(dab.target_m - step.target_m.x);
    step.on_regolith = dab.material == Material::regolith ? 1 : 0;
    return step;
}

gpu::Region dab_region(const Grid& grid, const Dab& dab) {
    const auto whole = [](double v) { return static_cast<int>(std::clamp(v, -1e6, 1e6)); };
    const int x0 = whole(std::ceil(grid.column_of(dab.x_m - dab.radius_m)));
    const int x1 = whole(std::floor(grid.column_of(dab.x_m + dab.radius_m)));
    const int y0 = whole(std::ceil(grid.row_of(dab.y_m + dab.radius_m)));
    const int y1 = whole(std::floor(grid.row_of(dab.y_m - dab.radius_m)));
    return {x0, y0, x1 - x0 + 1, y1 - y0 + 1};
}

Brush::Brush(const Terrain& terrain)
    : books("brush books", static_cast<std::size_t>(terrain.tiles.count()) * 2 * sizeof(double)),
      program_("sim/brush.comp") {
    books.fill(0);
}

void Brush::dab(Terrain& terrain, const Dab& dab) {
    const std::vector<int> tiles = terrain.tiles.touched_by(dab_region(terrain.grid(), dab));
    if (tiles.empty()) return;
    const DabStep step = dab_step(terrain.grid(), dab);
    terrain.bind(program_);
    books.bind_storage(1);
    const int columns = terrain.tiles.columns();
    const glm::ivec2 first(tiles.front() % columns, tiles.front() / columns);
    const glm::ivec2 last(tiles.back() % columns, tiles.back() / columns);
    program_.set("first_tile", first);
    program_.set("cell_m", step.cell_m);
    program_.set("dab_sample", step.sample);
    program_.set("dab_offset", step.offset);
    program_.set("dab_radius_m", step.radius_m);
    program_.set("dab_falloff", step.falloff);
    program_.set("dab_mode", step.mode);
    program_.set("dab_amount_m", step.amount_m);
    program_.set("dab_blend", step.blend);
    program_.set("dab_target_m", step.target_m);
    program_.set("dab_on_regolith", step.on_regolith);
    program_.dispatch(last.x - first.x + 1, last.y - first.y + 1);
    const gpu::Region low = terrain.tiles.region(tiles.front());
    const gpu::Region high = terrain.tiles.region(tiles.back());
    terrain.settle({low.x, low.y, high.x + high.width - low.x, high.y + high.height - low.y});
}

}  // namespace talus
