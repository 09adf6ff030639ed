#pragma once
#include <map>
#include <string>
#include <vector>

#include "sim/gpu/buffer.h"
#include "sim/gpu/program.h"
#include "sim/gpu/readback.h"
#include "sim/passes/sediment.h"
#include "sim/passes/water_settings.h"
#include "sim/terrain/terrain.h"

namespace talus {

/// Where the water came from and went, m³ since the start.
struct WaterBooks {
    double rain_m3 = 0;
    double springs_m3 = 0;
    double edges_in_m3 = 0;
    double edges_out_m3 = 0;
    double losses_m3 = 0;  ///< by infiltration and evaporation
    double sea_m3 = 0;
    double brush_in_m3 = 0;
    double brush_out_m3 = 0;
    double in_m3() const { return rain_m3 + springs_m3 + edges_in_m3 + sea_m3 + brush_in_m3; }
    double out_m3() const { return edges_out_m3 + losses_m3 + brush_out_m3; }
};

/// Moves the water: conservative shallow-water equations in second order (docs/numerics.md, "Water"), by
/// sub-steps whose length is found on the device from the fastest wave. Only tiles whose water moves, and
/// their neighbours, are computed; the others would keep their bits (law 2).
///
///     water.begin_tick(terrain, settings, tick_s, clock.simulated_s);
///     while (water.time_left_s() > 0) water.substep(terrain);
class Water {
  public:
    /// The terrain must have a water layer.
    explicit Water(const Terrain& terrain);

    /// Takes over what others changed of ground and water, and sets the time that sub-steps have to go. The
    /// settings hold for the whole tick.
    void begin_tick(Terrain& terrain, const WaterSettings& settings, const std::vector<Spring>& springs,
                    double tick_s, double start_s);
    /// The next sub-step; nothing after the tick's time is over.
    void substep(Terrain& terrain);
    /// Runs up to `substeps` of the present tick and says whether its time is over, without waiting for the
    /// device: where its answer is not there yet, no.
    bool advance(Terrain& terrain, int substeps);
    /// Of the present tick. Waits for the device.
    double time_left_s() const;
    /// Sub-steps that were sent to the device so far, those after a tick's end included. Does not wait.
    std::uint64_t sent() const { return sent_; }

    /// Waits for the device. Without what sea and brushes placed.
    WaterBooks read_books(const Grid& grid) const { return read_books(clock_, edge_books_, sources_, grid); }
    /// The same from copies of the first three of books().
    static WaterBooks read_books(const gpu::Buffer& clock, const gpu::Buffer& edges,
                                 const gpu::Buffer& sources, const Grid& grid);
    /// Sub-steps so far, and tiles computed in them together. Waits for the device.
    struct Work {
        std::uint64_t substeps = 0;
        std::uint64_t tiles = 0;
    };
    Work work() const;

    /// The books, for undo and the ledger: clock, edges, sources, and metres of solid that passed the edges,
    /// in and out, as they count for the bed.
    std::vector<gpu::Buffer*> books() { return {&clock_, &edge_books_, &sources_, &sediment_.edge_books}; }

  private:
    gpu::Program& stage_program(int stage);
    gpu::Program& edge_program();

    gpu::Program step_program_;
    gpu::Program bed_program_;
    gpu::Program loaded_bed_program_;
    std::map<int, gpu::Program> edge_programs_;   // by order and load
    std::map<int, gpu::Program> stage_programs_;  // by order, stage, friction, sources, load
    TileList active_;
    gpu::Buffer clock_;
    gpu::Buffer activity_;
    gpu::Buffer speeds_;
    Tiles::Reader read_;
    gpu::Buffer sources_;
    gpu::Buffer springs_;
    gpu::Buffer series_;
    gpu::Buffer edge_books_;

    Sediment sediment_;

    gpu::Readback poll_;
    std::uint64_t sent_ = 0;
    int expected_ = 1;  // sub-steps until the tick is over, as far as is known
    WaterSettings settings_;
    double tick_s_ = 0;
    int spring_count_ = 0;
};

}  // namespace talus
