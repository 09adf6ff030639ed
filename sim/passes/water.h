#pragma once
#include <array>
#include <map>
#include <string>
#include <vector>

#include "sim/gpu/buffer.h"
#include "sim/gpu/program.h"
#include "sim/gpu/readback.h"
#include "sim/passes/sediment.h"
#include "sim/terrain/terrain.h"

namespace talus {

/// What is beyond an edge of the map. The numbers are those of shaders/maths/water_edge.glsl.
enum class EdgeKind { wall = 0, open = 1, level = 2, inflow = 3, wave = 4, periodic = 5 };

/// Their names as parameters have them.
const std::vector<std::string>& edge_kinds();

/// The edges in the order of settings and books.
enum class Edge { north = 0, south = 1, west = 2, east = 3 };

enum class WaveForm { sine, solitary };

/// Settings of the water with units.
struct WaterSettings {
    int order = 2;  ///< of space and time: 1 is cheaper, 2 more exact
    double gravity_m_per_s2 = 9.81;
    double manning_s_per_m13 = 0;  ///< Manning's n; 0: no friction
    double rain_m_per_s = 0;
    bool rain_masked = false;   ///< rain falls where the mask is, not everywhere
    bool rain_painted = false;  ///< rain was painted somewhere, and falls there too
    double infiltration_m_per_s = 0;
    double evaporation_m_per_s = 0;
    std::array<EdgeKind, 4> edges{};
    double level_m = 0;          ///< held at level edges, still level at wave edges
    double inflow_m3_per_s = 0;  ///< over all inflow edges together, at its peak
    double inflow_rise_s = 0;    ///< from nothing to the peak; 0: at once
    double inflow_fall_s = 0;    ///< from the peak back to nothing; 0: it stays
    WaveForm wave_form = WaveForm::sine;
    double wave_height_m = 0;   ///< sine: amplitude; solitary: crest above the still level
    double wave_period_s = 10;  ///< sine
    double wave_depth_m = 10;   ///< solitary: still depth that gives the wave its length
    SedimentSettings sediment;
    bool wakes_slopes = false;  ///< thermal erosion hangs on what is under water
    bool skips_rest = true;     ///< false: every tile every sub-step, to compare with (law 2)
};

/// Throws talus::Error when a spring lies off the map, or its rate is not 0 to 1e9 m³/s.
void check_spring(const Grid& grid, const Spring& spring);

/// Inflow over all inflow edges at a time since the start, m³/s.
double inflow_at(const WaterSettings& settings, double time_s);

/// The wave maker's height above the still level at a time since the start, m.
double wave_at(const WaterSettings& settings, double time_s);

/// How much faster √(gd) is than a wave of this period (s) is in nature over this depth (m), as a share: the
/// true relation is ω² = g k tanh kd.
double shallow_speed_excess(double depth_m, double period_s, double gravity_m_per_s2);

/// Steps of the tables that edges read in a tick.
constexpr int edge_series_steps = 256;

/// Those tables over a tick: inflow, m²/s along the inflow edges, then the wave, m; a point more than steps
/// each.
std::vector<float> edge_series(const WaterSettings& settings, const Grid& grid, double tick_s,
                               double start_s);

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
    gpu::Buffer speeds_;
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
