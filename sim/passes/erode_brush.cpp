#include "sim/passes/erode_brush.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace talus {
namespace {

TerrainState flat(const Grid& grid) {
    return bedrock_terrain(grid, std::vector<float>(grid.count(), 0.0F));
}

double inverse_cells(const Grid& grid) {
    return 1 / grid.dx + 1 / grid.dy;
}

using real = double;
#include "maths/courant.glsl"
// Rain runs off rough ground slowly and subcritically: Manning's n of sheet flow is 0.1 to 0.4 s/m^(1/3)
// (Engman 1986). A torrent would hack steps across steep slopes instead of valleys along them.
constexpr double manning_of_sheets = 0.3;
constexpr double fastest_m_per_s = 5;
// Steep mountains keep their faces: only what water undercut breaks.
constexpr double steepest_bedrock_deg = 45;

}  // namespace

int erode_substeps(const Grid& grid, const ErodeDab& dab) {
    const double needed = dab.time_s * fastest_m_per_s * inverse_cells(grid) / water_courant;
    return static_cast<int>(std::clamp(std::ceil(needed), 1.0, 1024.0));
}

double erode_longest_s(const Grid& grid, const Dab& dab) {
    const gpu::Region window = erode_window(grid, dab);
    const double samples = static_cast<double>(window.width) * window.height;
    const double substeps = std::clamp(12.0 * 128 * 128 / samples, 1.0, 12.0);
    return substeps * water_courant / (fastest_m_per_s * inverse_cells(grid));
}

ErodeBrush::Patch::Patch(const Grid& grid)
    : terrain((flat(grid))),
      water((terrain.add(&Terrain::suspended), terrain.add(&Terrain::painted), terrain)),
      thermal(terrain),
      moved("erode brush water", grid.count() * sizeof(glm::vec4)) {}

// The water stays where it is on the map when the window moves.
void ErodeBrush::shift_water(glm::ivec2 by) {
    if (by == glm::ivec2(0)) return;
    const glm::ivec2 size(patch_->terrain.grid().nx, patch_->terrain.grid().ny);
    const glm::ivec2 from = glm::max(by, 0);
    const glm::ivec2 to = glm::max(-by, 0);
    const glm::ivec2 both = size - glm::abs(by);
    const auto shift = [&](DeviceLayer& layer) {
        const bool meet = both.x > 0 && both.y > 0;
        if (meet) layer.front.copy_to(patch_->moved, 0, layer.texels({from.x, from.y, both.x, both.y}));
        layer.front.fill(0);
        if (meet) layer.front.copy_from(patch_->moved, 0, layer.texels({to.x, to.y, both.x, both.y}));
    };
    shift(*patch_->terrain.water);
    shift(*patch_->terrain.suspended);
}

void ErodeBrush::place(const Terrain& terrain, const Dab& dab, const ErodeDab& how) {
    const gpu::Region window = erode_window(terrain.grid(), dab);
    const Grid grid{window.width, window.height, terrain.grid().dx, terrain.grid().dy};
    const bool fits = patch_ && patch_->terrain.grid() == grid;
    if (!fits) patch_ = std::make_unique<Patch>(grid);
    Terrain& patch = patch_->terrain;
    if (!fits || how.begins) {
        patch.water->front.fill(0);
        patch.suspended->front.fill(0);
    } else {
        shift_water(glm::ivec2(window.x, window.y) - corner_);
    }
    corner_ = {window.x, window.y};

    program_.bind_image("solid_in", terrain.solid.front);
    program_.bind_image("solid_out", patch.solid.front);
    program_.bind_image("ground_out", patch.ground);
    program_.bind_image("painted_out", patch.painted->front);
    patch.tiles.bind_for_stamping(program_);
    numbers_.set(dab_numbers(terrain.grid(), dab));
    set_dab(program_, terrain, numbers_);
    program_.set("window_corner", corner_);
    program_.set("window_samples", glm::ivec2(grid.nx, grid.ny));
    program_.set("is_painted", terrain.painted ? 1 : 0);
    program_.set("erode_rain", static_cast<float>(how.rain_mm_per_h));
    program_.dispatch((grid.nx + 15) / 16, (grid.ny + 15) / 16);
    gpu::barrier({gpu::Use::image, gpu::Use::texture_transfer, gpu::Use::storage, gpu::Use::buffer_transfer});
    patch.solid.back.copy_from(patch.solid.front, patch.solid.front.whole());
    patch.tiles.mark_all();
}

const Terrain& ErodeBrush::erode(const Terrain& terrain, const Dab& dab, const ErodeDab& how,
                                 WaterSettings water, const std::optional<ThermalSettings>& thermal) {
    // Until the dab is done.
    going_ = false;
    place(terrain, dab, how);
    Terrain& patch = patch_->terrain;
    const Grid& grid = patch.grid();
    if (thermal) {
        ThermalSettings slopes = *thermal;
        // Olsen's steps have no time.
        slopes.scheme = ThermalScheme::gradient;
        slopes.masked = true;
        slopes.bedrock_deg = std::max(slopes.bedrock_deg, steepest_bedrock_deg);
        slopes.rate_m2_per_s = natural_thermal_rate(grid, how.time_s, slopes.porosity);
        patch_->thermal.substep(patch, thermal_step(grid, slopes, how.time_s, 1));
    }
    water.edges.fill(EdgeKind::open);
    water.rain_m_per_s = 0;
    water.rain_masked = false;
    water.rain_painted = true;
    water.sediment.carried = true;
    water.sediment.masked = true;
    water.sediment.below_neighbours = true;
    water.manning_s_per_m13 = manning_of_sheets;
    water.sediment.acceleration = how.acceleration;
    patch_->water.begin_tick(patch, water, {}, how.time_s, 0);
    for (int i = erode_substeps(grid, how); i > 0; --i) patch_->water.substep(patch);
    return patch;
}

}  // namespace talus
