#pragma once
#include <cstdint>

#include "app/claims/water_scenes.h"
#include "sim/passes/thermal_settings.h"

namespace talus::claims {

/// A scene of water run to its end: Σ|h - exact| / Σ exact, and the sub-steps that it took.
struct SceneError {
    double relative_l1 = 0;
    std::uint64_t substeps = 0;
};
SceneError error_after(const scenes::WaterScene& scene);

/// What a lake over rough ground does in so many sub-steps, none of them skipped: nothing may move.
struct LakeMoved {
    double fastest_m_per_s = 0;
    double level_m = 0;
    std::uint64_t substeps = 0;
};
LakeMoved lake_at_rest(double datum_m, std::uint64_t substeps);

/// A small wave with so many crests along both sides of a periodic square, after some of its periods: how far
/// its speed is off √(gd), relative, and what is left of its amplitude.
struct WaveError {
    double speed = 0;
    double amplitude = 0;
};
WaveError small_wave_error(int waves_x, int waves_y);

/// A column of loose ground that collapsed into a cone, against the exact one (docs/numerics.md, "Thermal
/// erosion"). Sizes in samples of 1 m; the volume's cone must fit on n x n samples.
struct ConeError {
    int ticks = 0;
    double steepest_deg = 0;  ///< of 33
    double axis_m = 0;        ///< radius of the contour at a quarter of the peak, along the grid
    double diagonal_m = 0;    ///< and across it
    double exact_m = 0;       ///< what both should be
    double peak_m = 0;
    double exact_peak_m = 0;
    double ledger_of_moved = 0;  ///< what the ledger misses, relative to what moved
};
ConeError collapsed_column(int n, double radius_m, double height_m,
                           ThermalScheme scheme = ThermalScheme::gradient);

/// The largest speed of the water, m/s.
double fastest_of(const TerrainState& state);

}  // namespace talus::claims
