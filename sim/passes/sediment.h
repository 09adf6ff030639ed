#pragma once
#include <map>

#include "sim/budget.h"
#include "sim/gpu/buffer.h"
#include "sim/gpu/program.h"
#include "sim/passes/sediment_settings.h"
#include "sim/terrain/terrain.h"

namespace talus {

/// Settings in the units of shaders/maths/sediment_exchange.glsl, for a gravity (m/s²) and Manning's n. The
/// twin takes the same numbers.
struct SedimentStep {
    float drag = 0;
    float critical = 0;
    float regolith = 0;
    float bedrock = 0;
    float settling = 0;
    float speedup = 1;
    float bulking = 1;
    float per_rock = 1;   ///< 1 / speedup
    float per_loose = 1;  ///< 1 / (speedup * bulking)
    glm::vec2 strata{0};
    int masked = 0;
    int below = 0;
};
SedimentStep sediment_step(const SedimentSettings& settings, double gravity_m_per_s2, double manning);

/// Metres of regolith that a metre of solid makes, as the shaders count it.
float bulking_of(double porosity);

/// The exchange between bed and water after each of the water's sub-steps, and the books of solid that passes
/// the edges. The transport itself is part of the water's stages (sim/passes/water.h).
class Sediment {
  public:
    explicit Sediment(const Grid& grid);

    /// On the tiles of the list, for so many of the spans of the water's clock. `activity`: the water's,
    /// which it wakes where the bed moves.
    void exchange(Terrain& terrain, const SedimentStep& step, double gravity_m_per_s2, int eulers,
                  const gpu::Buffer& list, const gpu::Buffer& activity, const gpu::Buffer& clock);

    /// Of solid that passed the edges.
    Book book();

    /// Metres of solid in and out round the map, as they count for the bed, pairs of doubles.
    gpu::Buffer edge_books;

  private:
    gpu::Program program_;
    gpu::Program painted_program_;
    gpu::Program bed_program_;
};

}  // namespace talus
