#pragma once
#include <functional>
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "sim/passes/water.h"
#include "sim/terrain/terrain.h"

namespace talus::scenes {

/// What scenes begin with: walls, no friction, no waves, and solid that nothing takes.
WaterSettings scene_settings();

/// Water to start from, and where there is an exact answer, the water at any time. Functions of x east and y
/// north, metres, and the time, seconds: (depth m, discharge east m²/s, discharge north m²/s). A sample is
/// the middle of a control volume, at the borders too, so the first sample is at half a spacing.
struct WaterScene {
    std::string name;
    Grid grid;
    WaterSettings settings = scene_settings();
    double tick_s = 1;
    double end_s = 1;
    std::function<double(double, double)> bed;
    std::function<glm::dvec3(double, double, double)> water;
    bool knows_bed_beyond = false;                    ///< edges see the bed go on
    std::function<double(double, double)> manning{};  ///< by the land cover; null: the settings'

    TerrainState state() const;
};

WaterScene ritter(int n);
WaterScene stoker(int n);
WaterScene thacker_radial(int n);
WaterScene thacker_planar(int n);

/// A subcritical stream over a bed made for it, with Manning's friction (MacDonald 1997); its steady state is
/// exact. `rough_in_places`: Manning's n goes from 0.02 to 0.05 along it, by the land cover.
WaterScene macdonald(int n, bool rough_in_places = false);
/// A solitary wave of 0.019 of the depth (1 m) before a beach of cot 19.85 whose shore is at x = 10 m.
WaterScene solitary_on_beach(int n);
/// A progressive wave in water of 7 m on a periodic square: waves_x and waves_y crests along its sides.
WaterScene small_wave(int n, int waves_x, int waves_y);
/// Rain of 20 mm/h on a slope that falls eastwards, its drops from sample to sample varied by a fifth.
WaterScene rain_on_slope(double slope, int order);
/// Rain of 200 mm/h on ground that falls inwards from open edges, around a height; dry at first.
WaterScene rain_on_bowl(double datum_m, int order);
/// Water to a level over bumps that rise out of it and a rippled bed, at a datum.
WaterScene lake(int n, double datum_m);
/// Water that sloshes in a closed basin with islands, by seed.
WaterScene basin(int n, int seed);
/// A round column of water on a flat bed of the same water, low; rough ground where asked for, the same in
/// all four directions.
WaterScene radial_dam(int n, bool rough);

/// A terrain and its water, run by ticks.
class WaterRun {
  public:
    WaterRun(const TerrainState& state, const WaterSettings& settings);
    void tick(double tick_s);
    /// Whole ticks of at most tick_s that end at end_s.
    void run(double tick_s, double end_s);
    TerrainState read() const { return terrain.read(); }
    double time_s() const { return time_s_; }

    Terrain terrain;
    WaterSettings settings;
    std::vector<Spring> springs;
    Water water;

  private:
    double time_s_ = 0;
};

/// Σ|h - exact| / Σ exact over the samples.
double depth_error(const WaterScene& scene, const TerrainState& state, double time_s);

}  // namespace talus::scenes
