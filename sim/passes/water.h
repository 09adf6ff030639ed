#pragma once
#include <map>
#include <string>
#include <vector>

#include "sim/gpu/buffer.h"
#include "sim/gpu/program.h"
#include "sim/gpu/readback.h"
#include "sim/gpu/uniform_block.h"
#include "sim/passes/inflow_shares.h"
#include "sim/passes/pass_work.h"
#include "sim/passes/sediment.h"
#include "sim/passes/water_numbers.h"
#include "sim/passes/water_sections.h"
#include "sim/passes/water_settings.h"
#include "sim/terrain/terrain.h"

namespace talus {

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
    /// Runs up to `substeps` sub-steps of the present tick, lowers the number by those that it ran, and says
    /// whether the tick's time is over. Does not wait for the device: where its answer is not there yet, it
    /// is not over.
    bool advance(Terrain& terrain, int& substeps);
    /// Of the present tick. Waits for the device.
    double time_left_s() const;
    /// Sub-steps that were sent to the device so far, those after a tick's end included. Does not wait.
    std::uint64_t sent() const { return sent_; }

    /// Waits for the device. Without what sea and brushes placed.
    WaterBooks read_books(const Grid& grid);
    PassWork work() const;

    /// Counts what passes lines over the map.
    WaterSections sections;

    /// Of the clock, edges, sources, sections, and of solid that passed the edges.
    std::vector<Book> books();

  private:
    void fill_ghosts(Terrain& terrain, int stage);
    void count_sections(const Terrain& terrain, int stage);
    void run_stage(Terrain& terrain, int stage);
    std::vector<Book> own_books();
    gpu::Program& stage_program(int stage, bool counts_flow);
    gpu::Program& edge_program();
    void bind_buffers(gpu::Program& program) const;

    gpu::Program step_program_;
    gpu::Program bed_program_;
    gpu::Program loaded_bed_program_;
    std::map<int, gpu::Program> edge_programs_;   // by order, load and conveyance
    std::map<int, gpu::Program> stage_programs_;  // by what stage_program() asks for
    TileList active_;
    gpu::UniformBlock<WaterNumbers> numbers_;
    gpu::Buffer clock_;
    gpu::Buffer activity_;
    gpu::Buffer speeds_;
    Tiles::Reader read_;
    gpu::Buffer sources_;
    gpu::Buffer springs_;
    gpu::Buffer series_;
    gpu::Buffer bed_beyond_;
    gpu::Buffer edge_books_;

    InflowShares inflow_shares_;

    Sediment sediment_;

    gpu::Readback poll_;
    std::uint64_t sent_ = 0;
    int expected_ = 1;  // sub-steps until the tick is over, as far as is known
    WaterSettings settings_;
};

}  // namespace talus
