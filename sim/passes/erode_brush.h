#pragma once
#include <memory>
#include <optional>

#include "sim/passes/brush.h"
#include "sim/passes/thermal.h"
#include "sim/passes/water.h"
#include "sim/terrain/terrain.h"

namespace talus {

/// Sub-steps of water that an erode dab is given: enough for its time where nothing is faster than 5 m/s;
/// else less time passes. A number of its own asks the device for nothing.
int erode_substeps(const Grid& grid, const ErodeDab& dab);

/// The longest time of a dab whose sub-steps a frame has room for, s.
double erode_longest_s(const Grid& grid, const Dab& dab);

/// A brush that erodes: the solvers of water, sediment and slopes run on a copy of the ground around it. The
/// dab's weight scales the rain and the erosion. The brush's water is separate from the map's: it starts dry
/// with a stroke's first dab and is dropped after the last. Solid that it carries out of the copy is removed.
class ErodeBrush {
  public:
    /// Whether a dab can go on with the water of the one before.
    bool is_going() const { return going_; }
    /// Says so: after a dab that was done, unless it was its stroke's last.
    void set_going(bool going) { going_ = going; }

    /// Erodes the copy; `how` is the dab's act. Settings of water with those of its sediment, which say what
    /// gives way how easily; `thermal`: none, slopes do not slide.
    const Terrain& erode(const Terrain& terrain, const Dab& dab, const ErodeDab& how, WaterSettings water,
                         const std::optional<ThermalSettings>& thermal);

  private:
    void place(const Terrain& terrain, const Dab& dab, const ErodeDab& how);
    void shift_water(glm::ivec2 by);

    // The copy and its solvers, which stay for the next dab of this size.
    struct Patch {
        explicit Patch(const Grid& grid);
        Terrain terrain;
        Water water;
        Thermal thermal;
        gpu::Buffer moved;
    };
    std::unique_ptr<Patch> patch_;
    gpu::UniformBlock<DabNumbers> numbers_{"dab numbers"};
    gpu::Program program_{"sim/erode_brush.comp"};
    glm::ivec2 corner_{0};
    bool going_ = false;
};

}  // namespace talus
