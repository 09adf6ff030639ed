#include "sim/passes/brush.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "sim/gpu/error.h"
#include "sim/passes/erode_brush.h"
#include "sim/passes/paint.h"

namespace talus {

const std::vector<std::string>& brush_mode_names() {
    static const std::vector<std::string> names = {"raise", "lower",   "smooth", "flatten", "ramp",
                                                   "noise", "terrace", "stamp",  "erode"};
    return names;
}

const std::vector<std::string>& material_names() {
    static const std::vector<std::string> names = {"bedrock",  "regolith", "water",
                                                   "hardness", "mask",     "rain"};
    return names;
}

const std::vector<std::string>& falloff_curve_names() {
    static const std::vector<std::string> names = {"smooth", "linear", "round", "sharp"};
    return names;
}

const std::vector<std::string>& noise_kind_names() {
    static const std::vector<std::string> names = {"fbm", "ridged", "billow"};
    return names;
}

const std::vector<std::string>& stamp_mode_names() {
    static const std::vector<std::string> names = {"add", "higher", "lower", "replace"};
    return names;
}

void check_dab(const Dab& dab) {
    // Flatten away from its target exaggerates the relief.
    const double least_blend = dab.mode == BrushMode::flatten ? -1000 : 0;
    const double least_amount_m = dab.mode == BrushMode::noise || dab.mode == BrushMode::stamp ? -1e6 : 0;
    const struct {
        const char* name;
        double value;
        double low;
        double high;
    } fields[] = {{"x_m", dab.x_m, -1e9, 1e9},
                  {"y_m", dab.y_m, -1e9, 1e9},
                  {"radius_m", dab.radius_m, 1e-6, 1e9},
                  {"falloff", dab.falloff, 0, 1},
                  {"blend", dab.blend, least_blend, 1},
                  {"amount_m", dab.amount_m, least_amount_m, 1e6},
                  {"target_m", dab.target_m, -1e6, 1e6},
                  {"way_x_m", dab.way_m.x, -1e9, 1e9},
                  {"way_y_m", dab.way_m.y, -1e9, 1e9},
                  {"rise_m", dab.rise_m, -1e6, 1e6},
                  {"step_m", dab.step_m, 1e-3, 1e6},
                  {"flat", dab.flat, 0, 0.99},
                  {"wavelength_m", dab.noise.wavelength_m, 1e-3, 1e9},
                  {"octaves", static_cast<double>(dab.noise.octaves), 1, 16},
                  {"gain", dab.noise.gain, 0, 1},
                  {"warp", dab.noise.warp, 0, 10},
                  {"half_x_m", dab.stamp.half_m.x, 1e-6, 1e9},
                  {"half_y_m", dab.stamp.half_m.y, 1e-6, 1e9},
                  {"turn_deg", dab.stamp.turn_deg, -3600, 3600},
                  {"zero", dab.stamp.zero, -1e6, 1e6},
                  {"rain_mm_per_h", dab.erode.rain_mm_per_h, 0, 1e4},
                  {"time_s", dab.erode.time_s, 1e-6, 1e6},
                  {"acceleration", dab.erode.acceleration, 1, 1e5}};
    for (const auto& field : fields)
        if (!(field.value >= field.low && field.value <= field.high))
            throw Error(fmt::format("a dab's {} cannot be {}, it must be {} to {}", field.name, field.value,
                                    field.low, field.high));
    if (dab.is_paint() && !(dab.target_m >= 0 && dab.target_m <= most_painted(painted_layer(dab.material))))
        throw Error(fmt::format("a dab of {} cannot paint {}, it must be 0 to {}",
                                material_names()[static_cast<std::size_t>(dab.material)], dab.target_m,
                                most_painted(painted_layer(dab.material))));
    if (dab.masked && dab.is_paint() && dab.material == Material::mask)
        throw Error("a dab that paints the mask cannot be limited by it");
}

Dab everywhere(const Grid& grid, Dab dab) {
    dab.x_m = grid.width_m() / 2;
    dab.y_m = grid.height_m() / 2;
    dab.radius_m = grid.width_m() + grid.height_m() + grid.dx + grid.dy;
    dab.falloff = 0;
    dab.way_m = {0, 0};
    return dab;
}

PaintedLayer painted_layer(Material material) {
    return static_cast<PaintedLayer>(static_cast<int>(material) - static_cast<int>(Material::hardness));
}

DabStep dab_step(const Grid& grid, const Dab& dab, glm::ivec2 stamp_samples) {
    const double column = grid.column_of(dab.x_m);
    const double row = grid.row_of(dab.y_m);
    DabStep step;
    step.cell_m = glm::vec2(grid.dx, grid.dy);
    step.sample = glm::ivec2(std::floor(column), std::floor(row));
    step.offset = glm::vec2(column - std::floor(column), row - std::floor(row));
    step.radius_m = static_cast<float>(dab.radius_m);
    step.falloff = static_cast<float>(dab.falloff);
    step.curve = static_cast<int>(dab.curve);
    // Rows run southwards.
    step.length_m = glm::vec2(dab.way_m.x, -dab.way_m.y);
    step.rise_m = static_cast<float>(dab.rise_m);
    step.mode = static_cast<int>(dab.mode);
    step.amount_m = static_cast<float>(dab.amount_m);
    step.blend = static_cast<float>(dab.blend);
    step.target_m.x = static_cast<float>(dab.target_m);
    step.target_m.y = static_cast<float>(dab.target_m - step.target_m.x);
    step.on_regolith = dab.material == Material::regolith ? 1 : 0;
    const double turn = glm::radians(dab.stamp.turn_deg);
    const glm::dvec2 a_metre = glm::dvec2(stamp_samples - 1) / (2.0 * dab.stamp.half_m);
    const double side = dab.stamp.mirrored ? -1 : 1;
    step.stamp_columns = glm::dvec2(std::cos(turn), -std::sin(turn)) * a_metre.x * side;
    step.stamp_rows = glm::dvec2(std::sin(turn), std::cos(turn)) * a_metre.y;
    step.stamp_zero = static_cast<float>(dab.stamp.zero);
    return step;
}

gpu::Region dab_region(const Grid& grid, const Dab& dab) {
    if (dab.mode == BrushMode::erode) return erode_window(grid, dab);
    const auto whole = [](double v) { return static_cast<int>(std::clamp(v, -1e6, 1e6)); };
    const glm::dvec2 low = glm::min(glm::dvec2(0), dab.way_m) - dab.radius_m;
    const glm::dvec2 high = glm::max(glm::dvec2(0), dab.way_m) + dab.radius_m;
    const int x0 = whole(std::ceil(grid.column_of(dab.x_m + low.x)));
    const int x1 = whole(std::floor(grid.column_of(dab.x_m + high.x)));
    const int y0 = whole(std::ceil(grid.row_of(dab.y_m + high.y)));
    const int y1 = whole(std::floor(grid.row_of(dab.y_m + low.y)));
    return {x0, y0, x1 - x0 + 1, y1 - y0 + 1};
}

TileBlock tile_block(const Tiles& tiles, const std::vector<int>& touched) {
    const auto place = [&](int tile) { return glm::ivec2(tile % tiles.columns(), tile / tiles.columns()); };
    const glm::ivec2 first = place(touched.front());
    return {first, place(touched.back()) - first + 1};
}

void set_dab(gpu::Program& program, const Terrain& terrain, const Dab& dab, unsigned mask_unit) {
    const DabStep step = dab_step(terrain.grid(), dab);
    program.set("samples", glm::ivec2(terrain.grid().nx, terrain.grid().ny));
    program.set("tiles", glm::ivec2(terrain.tiles.columns(), terrain.tiles.rows()));
    program.set("cell_m", step.cell_m);
    program.set("dab_sample", step.sample);
    program.set("dab_offset", step.offset);
    program.set("dab_radius_m", step.radius_m);
    program.set("dab_falloff", step.falloff);
    program.set("dab_curve", step.curve);
    program.set("dab_length_m", step.length_m);
    program.set("dab_masked", dab.masked ? 1 : 0);
    if (dab.masked && terrain.painted) terrain.painted->front.bind_image(mask_unit, gpu::Access::read);
}

Brush::Brush(const Terrain& terrain)
    : books("brush books", static_cast<std::size_t>(terrain.tiles.count()) * sizeof(glm::dvec4)) {
    books.fill(0);
}

gpu::Program& Brush::program_of(BrushMode mode) {
    const auto found = programs_.find(mode);
    if (found != programs_.end()) return found->second;
    gpu::Program program({"sim/brush.comp"}, {fmt::format("DAB_MODE {}", static_cast<int>(mode))});
    return programs_.emplace(mode, std::move(program)).first->second;
}

template <typename Set>
void Brush::run(Terrain& terrain, const Dab& dab, Set&& set) {
    const gpu::Region region = dab_region(terrain.grid(), dab);
    const std::vector<int> tiles = terrain.tiles.touched_by(region);
    if (tiles.empty()) return;
    const glm::ivec2 low = glm::max(glm::ivec2(region.x, region.y), 0);
    const glm::ivec2 high = glm::min(glm::ivec2(region.x + region.width, region.y + region.height),
                                     glm::ivec2(terrain.grid().nx, terrain.grid().ny)) -
                            1;
    // Between two samples it reaches none.
    if (low.x > high.x || low.y > high.y) return;
    gpu::Program& program = program_of(dab.mode);
    terrain.bind(program);
    books.bind_storage(1);
    const TileBlock block = tile_block(terrain.tiles, tiles);
    program.set("first_tile", block.first);
    program.set("dab_low", low);
    program.set("dab_high", high);
    set(program);
    program.dispatch(block.size.x, block.size.y);
    gpu::barrier({gpu::Use::image, gpu::Use::sampler, gpu::Use::storage, gpu::Use::texture_transfer,
                  gpu::Use::buffer_transfer});
    terrain.settle({low.x, low.y, high.x - low.x + 1, high.y - low.y + 1});
}

void Brush::dab(Terrain& terrain, const Dab& dab, const gpu::Texture* stamp) {
    run(terrain, dab, [&](gpu::Program& program) {
        const glm::ivec2 stamp_samples = stamp ? glm::ivec2(stamp->width(), stamp->height()) : glm::ivec2(2);
        const DabStep step = dab_step(terrain.grid(), dab, stamp_samples);
        set_dab(program, terrain, dab, 3);
        program.set("dab_amount_m", step.amount_m);
        program.set("dab_blend", step.blend);
        program.set("dab_target_m", step.target_m);
        program.set("dab_on_regolith", step.on_regolith);
        if (dab.mode == BrushMode::ramp) program.set("dab_rise_m", step.rise_m);
        if (dab.mode == BrushMode::noise) {
            program.set("noise_kind", dab.noise.kind);
            program.set("noise_octaves", dab.noise.octaves);
            program.set("noise_gain", static_cast<float>(dab.noise.gain));
            program.set("noise_warp", static_cast<float>(dab.noise.warp));
            program.set("noise_seed", dab.noise.seed);
            program.set("noise_wave_m", static_cast<float>(dab.noise.wavelength_m));
        }
        if (dab.mode == BrushMode::terrace) {
            program.set("terrace_step_m", static_cast<float>(dab.step_m));
            program.set("terrace_flat", static_cast<float>(dab.flat));
        }
        if (dab.mode == BrushMode::stamp && stamp) {
            stamp->bind_image(4, gpu::Access::read);
            program.set("stamp_samples", stamp_samples);
            program.set("stamp_columns", step.stamp_columns);
            program.set("stamp_rows", step.stamp_rows);
            program.set("stamp_zero", step.stamp_zero);
            program.set("stamp_mode", static_cast<int>(dab.stamp.mode));
        }
    });
}

void Brush::take_over(Terrain& terrain, const Dab& dab, const Terrain& eroded, double settled) {
    run(terrain, dab, [&](gpu::Program& program) {
        eroded.solid.front.bind_image(4, gpu::Access::read);
        eroded.suspended->front.bind_image(5, gpu::Access::read);
        program.set("erode_settled", static_cast<float>(settled));
    });
}

}  // namespace talus
