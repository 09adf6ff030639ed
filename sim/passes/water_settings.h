#pragma once
#include <array>
#include <string>
#include <vector>

#include "sim/parameter_binding.h"
#include "sim/passes/sediment_settings.h"
#include "sim/terrain/terrain_state.h"
#include "sim/terrain/time_series.h"

namespace talus {

namespace glsl {
#include "maths/edge_kinds.glsl"
}  // namespace glsl

/// What is beyond an edge of the map.
enum class EdgeKind {
    wall = glsl::edge_wall,
    open = glsl::edge_open,
    level = glsl::edge_level,
    inflow = glsl::edge_inflow_kind,
    wave = glsl::edge_wave,
    periodic = glsl::edge_periodic
};

/// Their names as parameters have them.
const std::vector<std::string>& edge_kinds();

/// The edges in the order of settings and books.
enum class Edge { north = 0, south = 1, west = 2, east = 3 };

enum class WaveForm { sine, solitary, series };

/// What follows tables within the tick (sim/drives.h), in the units of the parameters; without rows: it
/// follows none.
struct WaterDrives {
    TimeSeries rain_mm_per_h;
    TimeSeries inflow_m3_per_s;  ///< over all inflow edges together, in place of rise, peak and fall
    TimeSeries sea_level_m;
    TimeSeries wave_height_m;  ///< above the still level, of WaveForm::series
    double since_s = 0;        ///< simulated time from which a tick's start is counted
    bool operator==(const WaterDrives&) const = default;
};

/// Settings of the water with units. Its values are the defaults of the parameters that set them.
struct WaterSettings {
    int order = 2;  ///< of space and time: 1 is cheaper, 2 more exact
    double gravity_m_per_s2 = 9.81;
    double manning_s_per_m13 = 0.03;  ///< Manning's n; 0: no friction
    double rain_m_per_s = 0;
    bool rain_masked = false;           ///< rain falls where the mask is, not everywhere
    bool rain_painted = false;          ///< rain was painted somewhere, and falls there too
    bool manning_painted = false;       ///< as is Manning's n, which holds there instead
    bool infiltration_painted = false;  ///< as is infiltration
    double infiltration_m_per_s = 0;
    double evaporation_m_per_s = 0;
    std::array<EdgeKind, 4> edges = {EdgeKind::open, EdgeKind::open, EdgeKind::open, EdgeKind::open};
    double level_m = 0;                 ///< held at level edges, still level at wave edges
    bool has_sea = false;               ///< a sea of this level stands beyond open edges: the level was given
    double inflow_m3_per_s = 0;         ///< over all inflow edges together, at its peak
    bool inflow_by_conveyance = false;  ///< spread so along each edge, not evenly
    double inflow_slope = 1e-3;         ///< of the uniform flow whose level spreads it so
    double inflow_rise_s = 0;           ///< from nothing to the peak; 0: at once
    double inflow_fall_s = 0;           ///< from the peak back to nothing; 0: it stays
    WaveForm wave_form = WaveForm::sine;
    double wave_height_m =
        1;  ///< sine: amplitude; solitary: crest above the still level; series: by its table alone
    double wave_period_s = 10;  ///< sine
    double wave_depth_m = 10;   ///< solitary: still depth that gives the wave its length
    WaterDrives driven;
    SedimentSettings sediment;
    bool counts_maps = false;  ///< flow, and wear and deposition by it, where the terrain has their layers
    bool skips_rest = true;    ///< false: every tile every sub-step, to compare with (law 2)
    bool operator==(const WaterSettings&) const = default;
};

/// The tables that the water reads within the tick, by the parameter that follows each.
struct WaterDrive {
    const char* parameter;
    TimeSeries WaterDrives::*table;
};
const std::vector<WaterDrive>& water_drives();

/// How much faster √(gd) is than a wave of this period (s) is in nature over this depth (m), as a share: the
/// true relation is ω² = g k tanh kd.
double shallow_speed_excess(double depth_m, double period_s, double gravity_m_per_s2);

const std::vector<BoundParameter<WaterSettings>>& water_parameters();
/// With the sediment's settings in it; what hangs on the layers that are there is the simulation's.
WaterSettings water_settings_of(const Parameters& parameters);
/// The parameter that says what is beyond an edge.
const std::string& boundary_parameter(Edge edge);
/// The kinds of the edges go with a map that turns by quarters of a circle, counterclockwise.
void turn_edges(Parameters& parameters, int quarters);
/// What the parameter of an edge is called then; another parameter's name stays.
std::string turned_edge_parameter(const std::string& name, int quarters);

}  // namespace talus
