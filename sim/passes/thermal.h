#pragma once
#include <map>

#include "sim/gpu/program.h"
#include "sim/passes/thermal_settings.h"
#include "sim/terrain/terrain.h"

namespace talus {

/// What a sub-step of thermal erosion is made with, in the units of shaders/maths/thermal.glsl. The twin
/// takes the same numbers.
struct ThermalStep {
    float repose_slope = 0;  ///< tangents: of regolith, dry; under water; of bedrock
    float wet_slope = 0;
    float bedrock_slope = 0;
    float bulking = 1;       ///< metres of regolith that a metre of solid makes
    bool masked = false;     ///< slopes slide as far as the mask says
    float weathering_m = 0;  ///< of bare bedrock in a sub-step
    glm::vec2 cell_m{1};
    glm::vec2 face_share{0};  ///< rate (m²/s) * sub-step (s) / spacing (m)
};

/// Sub-steps that a span of time needs: rate * dt * (1/dx² + 1/dy²) <= (1 - porosity)/2 in each
/// (docs/numerics.md). Throws talus::Error when there would be more than 10,000.
int thermal_substeps(const Grid& grid, const ThermalSettings& settings, double span_s);

/// One of `substeps` equal parts of the span.
ThermalStep thermal_step(const Grid& grid, const ThermalSettings& settings, double span_s, int substeps);

/// The largest rate (m²/s) whose tick is a single sub-step at four fifths of the stable length.
double natural_thermal_rate(const Grid& grid, double span_s, double porosity = 0);

/// Runs thermal erosion on the tiles that changed in the last sub-step, and their neighbours: the others
/// would keep their bits (law 2).
class Thermal {
  public:
    explicit Thermal(const Terrain& terrain);
    void substep(Terrain& terrain, const ThermalStep& step);

  private:
    gpu::Program& program_of(bool wet, bool masked);

    std::map<int, gpu::Program> programs_;  // by wet and masked
    TileList active_;
    Tiles::Reader read_;
};

}  // namespace talus
