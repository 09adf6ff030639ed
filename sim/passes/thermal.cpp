#include "sim/passes/thermal.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "sim/gpu/error.h"
#include "sim/passes/sediment.h"

namespace talus {
namespace {

constexpr int max_substeps = 10000;

double inverse_squares(const Grid& grid) {
    return 1 / (grid.dx * grid.dx) + 1 / (grid.dy * grid.dy);
}

}  // namespace

int thermal_substeps(const Grid& grid, const ThermalSettings& settings, double span_s) {
    const double needed =
        std::ceil(settings.rate_m2_per_s * span_s * inverse_squares(grid) / (0.5 * (1 - settings.porosity)));
    if (needed > max_substeps)
        throw Error(fmt::format(
            "thermal.rate_m2_per_s = {} needs {:.0f} sub-steps a tick on cells of {} m, at most {} are "
            "run: lower it or time.tick_s",
            settings.rate_m2_per_s, needed, std::min(grid.dx, grid.dy), max_substeps));
    return std::max(1, static_cast<int>(needed));
}

ThermalStep thermal_step(const Grid& grid, const ThermalSettings& settings, double span_s, int substeps) {
    const double dt = span_s / substeps;
    ThermalStep step;
    const auto slope = [](double degrees) {
        return static_cast<float>(std::tan(degrees * std::numbers::pi / 180));
    };
    step.repose_slope = slope(settings.repose_deg);
    step.wet_slope = slope(settings.wet_deg);
    step.bedrock_slope = slope(settings.bedrock_deg);
    step.bulking = bulking_of(settings.porosity);
    step.masked = settings.masked;
    step.weathering_m = static_cast<float>(settings.weathering_m_per_s * dt);
    step.cell_m = glm::vec2(grid.dx, grid.dy);
    step.face_share = glm::vec2(settings.rate_m2_per_s * dt / grid.dx, settings.rate_m2_per_s * dt / grid.dy);
    return step;
}

double natural_thermal_rate(const Grid& grid, double span_s, double porosity) {
    return 0.4 * (1 - porosity) / (span_s * inverse_squares(grid));
}

Thermal::Thermal(const Terrain& terrain) : active_(terrain.tiles.count()) {}

gpu::Program& Thermal::program_of(bool wet, bool masked) {
    const int key = (wet ? 1 : 0) + (masked ? 2 : 0);
    auto found = programs_.find(key);
    if (found == programs_.end()) {
        std::vector<std::string> defines;
        if (wet) defines.emplace_back("WET 1");
        if (masked) defines.emplace_back("MASKED 1");
        found = programs_.emplace(key, gpu::Program({"sim/thermal.comp"}, defines)).first;
    }
    return found->second;
}

void Thermal::substep(Terrain& terrain, const ThermalStep& step) {
    // Where nothing was painted the mask is 0, and nothing slides.
    if (step.masked && !terrain.painted) return;
    const bool wet = terrain.water && step.wet_slope != step.repose_slope;
    // All that a slope may hang on.
    const std::uint32_t changes =
        Tiles::ground | Tiles::eroded | Tiles::placed | Tiles::painted | (wet ? Tiles::water : 0U);
    terrain.tiles.list(changes, read_, -1, 1, 16, active_);
    gpu::Program& program = program_of(wet, step.masked);
    if (wet) program.bind_image("water", terrain.water->front);
    if (step.masked) program.bind_image("painted", terrain.painted->front);
    terrain.bind(program);
    program.bind_storage("TileList", active_.buffer);
    program.set("cell_m", step.cell_m);
    program.set("repose_slope", step.repose_slope);
    program.set("wet_slope", step.wet_slope);
    program.set("bedrock_slope", step.bedrock_slope);
    program.set("face_share", step.face_share);
    program.set("thermal_bulking", step.bulking);
    program.set("weathering", step.weathering_m);
    program.dispatch_indirect(active_.buffer);
    gpu::barrier({gpu::Use::image, gpu::Use::sampler, gpu::Use::storage, gpu::Use::texture_transfer,
                  gpu::Use::buffer_transfer});
    terrain.swap();
}

}  // namespace talus
