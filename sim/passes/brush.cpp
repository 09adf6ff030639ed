#include "sim/passes/brush.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sim/gpu/error.h"
#include "sim/passes/paint.h"

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
    if (dab.is_paint() && !(dab.target_m >= 0 && dab.target_m <= most_painted(painted_layer(dab.material))))
        throw Error(fmt::format("a dab of {} cannot paint {}, it must be 0 to {}",
                                material_names()[static_cast<std::size_t>(dab.material)], dab.target_m,
                                most_painted(painted_layer(dab.material))));
}

const std::vector<std::string>& material_names() {
    static const std::vector<std::string> names = {"bedrock",  "regolith", "water",
                                                   "hardness", "mask",     "rain"};
    return names;
}

PaintedLayer painted_layer(Material material) {
    return static_cast<PaintedLayer>(static_cast<int>(material) - static_cast<int>(Material::hardness));
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

TileBlock tile_block(const Tiles& tiles, const std::vector<int>& touched) {
    const auto place = [&](int tile) { return glm::ivec2(tile % tiles.columns(), tile / tiles.columns()); };
    const glm::ivec2 first = place(touched.front());
    return {first, place(touched.back()) - first + 1};
}

void set_dab(gpu::Program& program, const Terrain& terrain, const Dab& dab) {
    const DabStep step = dab_step(terrain.grid(), dab);
    program.set("samples", glm::ivec2(terrain.grid().nx, terrain.grid().ny));
    program.set("tiles", glm::ivec2(terrain.tiles.columns(), terrain.tiles.rows()));
    program.set("cell_m", step.cell_m);
    program.set("dab_sample", step.sample);
    program.set("dab_offset", step.offset);
    program.set("dab_radius_m", step.radius_m);
    program.set("dab_falloff", step.falloff);
}

Brush::Brush(const Terrain& terrain)
    : books("brush books", static_cast<std::size_t>(terrain.tiles.count()) * sizeof(glm::dvec4)),
      program_("sim/brush.comp") {
    books.fill(0);
}

void Brush::dab(Terrain& terrain, const Dab& dab) {
    const std::vector<int> tiles = terrain.tiles.touched_by(dab_region(terrain.grid(), dab));
    if (tiles.empty()) return;
    const DabStep step = dab_step(terrain.grid(), dab);
    terrain.bind(program_);
    books.bind_storage(1);
    set_dab(program_, terrain, dab);
    const TileBlock block = tile_block(terrain.tiles, tiles);
    program_.set("first_tile", block.first);
    program_.set("dab_mode", step.mode);
    program_.set("dab_amount_m", step.amount_m);
    program_.set("dab_blend", step.blend);
    program_.set("dab_target_m", step.target_m);
    program_.set("dab_on_regolith", step.on_regolith);
    program_.dispatch(block.size.x, block.size.y);
    const gpu::Region low = terrain.tiles.region(tiles.front());
    const gpu::Region high = terrain.tiles.region(tiles.back());
    terrain.settle({low.x, low.y, high.x + high.width - low.x, high.y + high.height - low.y});
}

}  // namespace talus
