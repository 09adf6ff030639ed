#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "sim/terrain/grid.h"
#include "sim/terrain/painted_numbers.h"

namespace talus {

namespace glsl {
#include "maths/brush_modes.glsl"
}

/// What raise adds; lower takes regolith before bedrock, or water alone. The others are painted numbers
/// (sim/terrain/painted_numbers.h): raise brings them nearer to the dab's target, lower to 0, or to what the
/// parameters say.
enum class Material {
    bedrock = 0,
    regolith = 1,
    water = 2,
    hardness = 3,
    mask = 4,
    rain = 5,
    manning = 6,
    infiltration = 7
};
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

const std::vector<std::string>& noise_kind_names();

// The effects of a dab, a small struct each. `digs`: its amount may be below 0. `exaggerates`: its blend may
// be below 0. `has_object`: journals write its fields in an object of its own. visit_fields() lists each
// field once, for journals, checks and shader uniforms. It calls `visit` with a field's name and value; for a
// number or a pair of numbers also with the smallest and largest value, for a choice with the names of its
// values. A shader gets a field by a line of shaders/maths/dab_numbers.glsl named by effect and field:
// ramp_rise_m.

/// Adds the dab's material, or brings a painted number nearer to its target.
struct RaiseDab {
    static constexpr const char* name = "raise";
    bool operator==(const RaiseDab&) const = default;
};

/// Takes it, or brings a painted number nearer to 0, or to what the parameters say.
struct LowerDab {
    static constexpr const char* name = "lower";
    bool operator==(const LowerDab&) const = default;
};

/// Brings the ground nearer to the mean of its neighbours.
struct SmoothDab {
    static constexpr const char* name = "smooth";
    bool operator==(const SmoothDab&) const = default;
};

/// Brings the ground nearer to the target; with a blend below 0 away from it, which exaggerates the relief.
struct FlattenDab {
    static constexpr const char* name = "flatten";
    static constexpr bool exaggerates = true;
    bool operator==(const FlattenDab&) const = default;
};

/// A slope from the dab to the other end of its line.
struct RampDab {
    static constexpr const char* name = "ramp";
    glm::dvec2 way_m{0};  ///< from here to the other end: the dab lies along a line
    double rise_m = 0;    ///< how much higher its end is
    template <typename Self, typename Visit>
    static void visit_fields(Self& self, Visit&& visit) {
        visit("way_m", self.way_m, -1e9, 1e9);
        visit("rise_m", self.rise_m, -1e6, 1e6);
    }
    bool operator==(const RampDab&) const = default;
};

/// Adds relief out of noise (shaders/maths/brush_noise.glsl).
struct NoiseDab {
    static constexpr const char* name = "noise";
    static constexpr bool digs = true;
    static constexpr bool has_object = true;
    int kind = glsl::noise_fbm;  ///< or noise_ridged, noise_billow
    double wavelength_m = 500;
    int octaves = 6;
    double gain = 0.5;  ///< an octave against the one before it
    double warp = 0;    ///< how far the plane is bent first, in wavelengths
    std::uint32_t seed = 1;
    template <typename Self, typename Visit>
    static void visit_fields(Self& self, Visit&& visit) {
        visit("kind", self.kind, noise_kind_names());
        visit("wavelength_m", self.wavelength_m, 1e-3, 1e9);
        visit("octaves", self.octaves, 1, 16);
        visit("gain", self.gain, 0, 1);
        visit("warp", self.warp, 0, 10);
        visit("seed", self.seed, 0, 4294967295.0);
    }
    bool operator==(const NoiseDab&) const = default;
};

/// Cuts slopes into steps.
struct TerraceDab {
    static constexpr const char* name = "terrace";
    double step_m = 50;  ///< height of a step
    double flat = 0.5;   ///< share of a step that is level, 0 … 0.99
    template <typename Self, typename Visit>
    static void visit_fields(Self& self, Visit&& visit) {
        visit("step_m", self.step_m, 1e-3, 1e6);
        visit("flat", self.flat, 0, 0.99);
    }
    bool operator==(const TerraceDab&) const = default;
};

/// What a stamp does with the ground: adds, lifts what is lower, lowers what is higher, or takes its place.
enum class StampMode {
    add = glsl::stamp_add,
    higher = glsl::stamp_higher,
    lower = glsl::stamp_lower,
    replace = glsl::stamp_replace
};
const std::vector<std::string>& stamp_mode_names();

/// Presses the stamp: half its width and height, how it is turned, counterclockwise, and which of its
/// heights, 0 to 1, stands on the ground: what is lower digs.
struct StampDab {
    static constexpr const char* name = "stamp";
    static constexpr bool digs = true;
    static constexpr bool has_object = true;
    StampMode mode = StampMode::add;
    glm::dvec2 half_m{1};
    double turn_deg = 0;
    bool mirrored = false;  ///< west for east
    double zero = 0;
    template <typename Self, typename Visit>
    static void visit_fields(Self& self, Visit&& visit) {
        visit("mode", self.mode, stamp_mode_names());
        visit("half_m", self.half_m, 1e-6, 1e9);
        visit("turn_deg", self.turn_deg, -3600, 3600);
        visit("mirrored", self.mirrored);
        visit("zero", self.zero, -1e6, 1e6);
    }
    bool operator==(const StampDab&) const = default;
};

/// Lets rain erode the ground under the dab (sim/passes/erode_brush.h).
struct ErodeDab {
    static constexpr const char* name = "erode";
    static constexpr bool has_object = true;
    double rain_mm_per_h = 5000;  ///< in the middle
    double time_s = 1;            ///< simulated
    double acceleration = 3000;   ///< how often each exchange counts for the ground
    bool begins = true;           ///< on dry ground; else with the water of the dab before
    bool ends = true;             ///< what the water carries settles where it is
    template <typename Self, typename Visit>
    static void visit_fields(Self& self, Visit&& visit) {
        visit("rain_mm_per_h", self.rain_mm_per_h, 0, 1e4);
        visit("time_s", self.time_s, 1e-6, 1e6);
        visit("acceleration", self.acceleration, 1, 1e5);
        visit("begins", self.begins);
        visit("ends", self.ends);
    }
    bool operator==(const ErodeDab&) const = default;
};

/// What a path is; the ground is shaped by the other fields of a PathDab alone.
enum class PathKind { road, river, wall, ditch, breach };
const std::vector<std::string>& path_kind_names();

/// Shapes the ground along a line: a road, a river's bed, a wall, a ditch, a breach. The line's height holds
/// across its width; beside it the sides rise or fall from there to the ground. The dab's centre is at the
/// line's first point, its radius is how far from the line it reaches, its target a height near the line's,
/// which floats measure the line's heights from.
struct PathDab {
    static constexpr const char* name = "path";
    static constexpr bool has_object = true;
    static constexpr std::size_t most_points = 8192;
    PathKind kind = PathKind::road;
    std::vector<glm::dvec3> points_m = {glm::dvec3(0), glm::dvec3(1, 0, 0)};  ///< east, north, height
    double half_width_m = 4;
    double cut_slope = 1;   ///< of its sides where the ground is higher: rise over run
    double fill_slope = 1;  ///< and where it is lower
    bool cuts = true;       ///< takes what is higher
    bool fills = true;      ///< fills what is lower
    template <typename Self, typename Visit>
    static void visit_fields(Self& self, Visit&& visit) {
        visit("kind", self.kind, path_kind_names());
        visit("points_m", self.points_m, -1e9, 1e9);
        visit("half_width_m", self.half_width_m, 0, 1e6);
        visit("cut_slope", self.cut_slope, 1e-3, 1e6);
        visit("fill_slope", self.fill_slope, 1e-3, 1e6);
        visit("cuts", self.cuts);
        visit("fills", self.fills);
    }
    bool operator==(const PathDab&) const = default;
};

/// One of them, in the order of their numbers in shaders/maths/brush_modes.glsl.
using DabEffect = std::variant<RaiseDab, LowerDab, SmoothDab, FlattenDab, RampDab, NoiseDab, TerraceDab,
                               StampDab, ErodeDab, PathDab>;
enum class BrushMode {
    raise = glsl::brush_mode_raise,
    lower = glsl::brush_mode_lower,
    smooth = glsl::brush_mode_smooth,
    flatten = glsl::brush_mode_flatten,
    ramp = glsl::brush_mode_ramp,
    noise = glsl::brush_mode_noise,
    terrace = glsl::brush_mode_terrace,
    stamp = glsl::brush_mode_stamp,
    erode = glsl::brush_mode_erode,
    path = glsl::brush_mode_path
};
/// Their names as journals have them.
const std::vector<std::string>& brush_mode_names();
/// The effect of a mode, with the defaults of its fields.
DabEffect effect_of(BrushMode mode);

/// One dab: what a brush does to the ground in one moment. World coordinates, metres.
struct Dab {
    DabEffect effect;
    // Its footprint, which every dab has.
    double x_m = 0;
    double y_m = 0;
    double radius_m = 1;
    double falloff = 1;  ///< 0 hard edge … 1 soft all the way
    double amount_m =
        0;  ///< raise, lower: metres in the middle; noise, stamp: the height of 1, below 0 a hollow
    double blend =
        0;  ///< smooth, flatten, ramp, terrace, stamp, paint: share of the way in the middle, 0 … 1
    /// Flatten: the height to reach; ramp: at its beginning; terrace: of a step; stamp: that its zero
    /// stands on; paint: the value, as PaintedNumber says.
    double target_m = 0;
    /// What raise adds and lower takes; the other effects change the ground whatever it is.
    Material material = Material::bedrock;
    FalloffCurve curve = FalloffCurve::smooth;
    bool masked = false;  ///< as far as the painted mask says

    BrushMode mode() const { return static_cast<BrushMode>(effect.index()); }
    /// Null: the dab does something else.
    template <typename Effect>
    const Effect* as() const {
        return std::get_if<Effect>(&effect);
    }
    template <typename Effect>
    Effect* as() {
        return std::get_if<Effect>(&effect);
    }
    /// From here to the other end of the line that it lies along; 0: a dab of one place.
    glm::dvec2 way_m() const { return as<RampDab>() ? as<RampDab>()->way_m : glm::dvec2(0); }
    /// Whether the dab changes the water rather than the ground.
    bool is_water() const { return material == Material::water && brings_or_takes(); }
    /// Whether it paints a number of a layer rather than change the ground.
    bool is_paint() const { return material >= Material::hardness && brings_or_takes(); }
    bool operator==(const Dab&) const = default;

  private:
    bool brings_or_takes() const { return as<RaiseDab>() || as<LowerDab>(); }
};

// What effects say of themselves by constants of these names.
template <typename Effect>
concept Digs = requires {
    Effect::digs;
};
template <typename Effect>
concept Exaggerates = requires {
    Effect::exaggerates;
};
template <typename Effect>
concept HasObject = requires {
    Effect::has_object;
};

/// Visits the fields of a dab's footprint, as those of its effect (DabEffect).
template <typename AnyDab, typename Visit>
void visit_footprint(AnyDab& dab, Visit&& visit) {
    const auto [digs, exaggerates] = std::visit(
        [](const auto& effect) {
            using Effect = std::decay_t<decltype(effect)>;
            return std::pair(Digs<Effect>, Exaggerates<Effect>);
        },
        dab.effect);
    visit("x_m", dab.x_m, -1e9, 1e9);
    visit("y_m", dab.y_m, -1e9, 1e9);
    visit("radius_m", dab.radius_m, 1e-6, 1e9);
    visit("falloff", dab.falloff, 0, 1);
    visit("amount_m", dab.amount_m, digs ? -1e6 : 0, 1e6);
    visit("blend", dab.blend, exaggerates ? -1000 : 0, 1);
    visit("target_m", dab.target_m, -1e6, 1e6);
    visit("material", dab.material, material_names());
    visit("curve", dab.curve, falloff_curve_names());
    visit("masked", dab.masked);
}

/// Visits the fields that the dab's effect has besides.
template <typename AnyDab, typename Visit>
void visit_own(AnyDab& dab, Visit&& visit) {
    std::visit(
        [&](auto& act) {
            if constexpr (requires { act.visit_fields(act, visit); }) act.visit_fields(act, visit);
        },
        dab.effect);
}

/// Whether journals write the effect's fields in an object of its own rather than beside the footprint's.
bool has_object(const DabEffect& effect);

/// Throws talus::Error that names the field when a dab cannot be made.
void check_dab(const Dab& dab);

/// The number that a painted material paints.
PaintedNumber painted_number(Material material);

/// A dab of everything: the same everywhere on the terrain.
Dab everywhere(const Grid& grid, Dab dab);

}  // namespace talus
