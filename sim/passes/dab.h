#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "sim/terrain/grid.h"
#include "sim/terrain/terrain_state.h"

namespace talus {

namespace glsl {
#include "maths/brush_modes.glsl"
}

enum class BrushMode {
    raise = glsl::brush_mode_raise,
    lower = glsl::brush_mode_lower,
    smooth = glsl::brush_mode_smooth,
    flatten = glsl::brush_mode_flatten,
    ramp = glsl::brush_mode_ramp,
    noise = glsl::brush_mode_noise,
    terrace = glsl::brush_mode_terrace,
    stamp = glsl::brush_mode_stamp,
    erode = glsl::brush_mode_erode
};
/// Their names as journals have them.
const std::vector<std::string>& brush_mode_names();
/// What raise adds; lower takes regolith before bedrock, or water alone. Hardness, mask and rain are painted:
/// raise brings them nearer to the dab's target, lower to 0.
enum class Material { bedrock = 0, regolith = 1, water = 2, hardness = 3, mask = 4, rain = 5 };
/// Their names as parameters and journals have them.
const std::vector<std::string>& material_names();
/// How a dab fades from its middle to its edge: by a cubic, straight, like a ball, like a thorn.
enum class FalloffCurve {
    smooth = glsl::falloff_smooth,
    linear = glsl::falloff_linear,
    round = glsl::falloff_round,
    sharp = glsl::falloff_sharp
};
const std::vector<std::string>& falloff_curve_names();

/// The relief of a noise brush (shaders/maths/brush_noise.glsl).
struct NoiseSettings {
    int kind = glsl::noise_fbm;  ///< or noise_ridged, noise_billow
    double wavelength_m = 100;
    int octaves = 6;
    double gain = 0.5;  ///< an octave against the one before it
    double warp = 0;    ///< how far the plane is bent first, in wavelengths
    std::uint32_t seed = 1;
    bool operator==(const NoiseSettings&) const = default;
};
const std::vector<std::string>& noise_kind_names();

/// What a stamp brush does with the ground: adds, lifts what is lower, lowers what is higher, or takes its
/// place.
enum class StampMode {
    add = glsl::stamp_add,
    higher = glsl::stamp_higher,
    lower = glsl::stamp_lower,
    replace = glsl::stamp_replace
};
const std::vector<std::string>& stamp_mode_names();

/// How a stamp lies: half its width and height, how it is turned, counterclockwise, and which of its heights,
/// 0 to 1, stands on the ground: what is lower digs.
struct StampPlacement {
    StampMode mode = StampMode::add;
    glm::dvec2 half_m{1};
    double turn_deg = 0;
    bool mirrored = false;  ///< west for east
    double zero = 0;
    bool operator==(const StampPlacement&) const = default;
};

/// How a dab of erosion acts (sim/passes/erode_brush.h).
struct ErodeSettings {
    double rain_mm_per_h = 1000;  ///< in the middle
    double time_s = 1;            ///< simulated
    double acceleration = 100;    ///< how often each exchange counts for the ground
    bool begins = true;           ///< on dry ground; else with the water of the dab before
    bool ends = true;             ///< what the water carries settles where it is
    bool operator==(const ErodeSettings&) const = default;
};

/// One dab: what a brush does to the ground in one moment. World coordinates, metres.
struct Dab {
    BrushMode mode = BrushMode::raise;
    double x_m = 0;
    double y_m = 0;
    double radius_m = 1;
    double falloff = 1;  ///< 0 hard edge … 1 soft all the way
    double amount_m =
        0;  ///< raise, lower: metres in the middle; noise, stamp: the height of 1, below 0 a hollow
    double blend =
        0;  ///< smooth, flatten, ramp, terrace, stamp, paint: share of the way in the middle, 0 … 1
    /// Flatten: the height to reach; ramp: at its beginning; terrace: of a step; stamp: that its zero
    /// stands on; paint: the value, as PaintedLayer says.
    double target_m = 0;
    /// What raise adds and lower takes; the other modes act on the ground whatever it is.
    Material material = Material::bedrock;
    FalloffCurve curve = FalloffCurve::smooth;
    bool masked = false;  ///< as far as the painted mask says
    glm::dvec2 way_m{0};  ///< from here to the other end: the dab of a ramp lies along a line
    double rise_m = 0;    ///< ramp: how much higher its end is
    double step_m = 1;    ///< terrace: height of a step
    double flat = 0.5;    ///< terrace: share of a step that is level, 0 … 0.99
    NoiseSettings noise = NoiseSettings();    ///< noise
    StampPlacement stamp = StampPlacement();  ///< stamp
    ErodeSettings erode = ErodeSettings();    ///< erode

    /// Whether the dab changes the water rather than the ground.
    bool is_water() const {
        return material == Material::water && (mode == BrushMode::raise || mode == BrushMode::lower);
    }
    /// Whether it paints a layer rather than change the ground.
    bool is_paint() const {
        return material >= Material::hardness && (mode == BrushMode::raise || mode == BrushMode::lower);
    }
    bool operator==(const Dab&) const = default;
};

/// Throws talus::Error that names the field when a dab cannot be made.
void check_dab(const Dab& dab);

/// The layer that a painted material paints.
PaintedLayer painted_layer(Material material);

/// A dab of everything: the same everywhere on the terrain.
Dab everywhere(const Grid& grid, Dab dab);

}  // namespace talus
