#pragma once
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "render/camera.h"
#include "render/methods/method.h"
#include "render/own_numbers.h"
#include "sim/parameters.h"
#include "sim/terrain/terrain.h"

namespace talus::render {

/// What a view's colours mean: a title with unit, and the values at the scale's ends.
struct Legend {
    std::string title;
    double low = 0;
    double high = 0;
    std::string unit;
    enum class Scale { map, grey, direction, difference, none } scale = Scale::map;
    int bands = 0;  ///< a scale of so many flat steps; 0: smooth
    /// Instead of a scale: what single colours mean, by kind (render/methods/method.h).
    std::vector<std::pair<double, std::string>> kinds = {};
};

/// What the renderer takes from the parameters of drawing.
struct ViewSettings {
    std::string method = "hybrid";
    double tolerance_px = 0.5;
    std::string view = "shaded";  ///< a name of `views()`
    glm::dvec3 sun{0, 0, 1};      ///< unit vector towards the sun: east, north, up
    bool shadows = true;
    bool occlusion = true;
    double gravity_m_per_s2 = 9.81;  ///< of the water that is shown
    OwnNumbers numbers;              ///< of views and methods
    /// Leaves out what is costly and little missed where frames are late: shadows, and ground that water
    /// mirrors.
    bool quick = false;
    bool operator==(const ViewSettings&) const = default;
};
/// `drawing` must have render_parameters() among them, `simulation` those of the simulation.
ViewSettings view_settings(const Parameters& drawing, const Parameters& simulation);

/// Whether a number is where a scale ends, and what it is rounded up to where it follows what the terrain
/// holds (render/view_range.h).
enum class EndsScale { no, at_step, at_power_of_ten };

/// A number that a view's shader takes as a uniform: a parameter of its own, or always the same.
struct ViewNumber {
    std::string uniform;
    std::optional<Parameter> parameter;
    double fixed = 0;
    bool of_drape = false;  ///< it colours the draped picture alone
    bool of_bare = false;   ///< it colours ground alone over which no picture is draped
    EndsScale ends_scale = EndsScale::no;

    /// As the settings have it. Of a choice: which one, from 0.
    double in(const ViewSettings& settings) const;
};

/// How the surface is coloured. A view is a line of `views()` and its shader, shaders/render/views/NAME.glsl.
struct View {
    std::string name;
    std::string label = "";  ///< as a person reads it; empty: its name tells that
    std::vector<ViewNumber> numbers = {};
    /// Its legend: a scale from 0 to `scale_end`, or to its first number where that is not set. Without a
    /// title there is none.
    std::string title = "";
    std::string unit = "";
    Legend::Scale scale = Legend::Scale::map;
    std::optional<double> scale_end = std::nullopt;
    /// Where the legend is no such scale; null: it is.
    std::vector<Legend> (*legend)(const View&, const ViewSettings&, glm::dvec2 lowest_highest_m) = nullptr;
    /// The layers that it shows, at most three. The ground is grey where the terrain has none of them. Empty:
    /// it needs none.
    std::vector<std::optional<DeviceLayer> Terrain::*> layers = {};
    Detail detail = Detail::none;  ///< what it needs of a method beside distances
    bool whole = false;            ///< it looks at what only a terrain that is held as a whole has
    bool sky_too = false;          ///< colours pixels whose rays hit nothing
    bool natural = false;          ///< sun, shadow, sky and water as in nature
};
const std::vector<View>& views();
/// The one of this name. Throws talus::Error where there is none.
const View& view_named(const std::string& name);

/// The parameters of drawing (law 8): they change the picture, never the terrain.
std::vector<Parameter> render_parameters();

/// Whether a parameter of drawing can change the picture now. Those that methods and views declare of their
/// own can while it is theirs that is drawn. `drawing`: as above; `draped`: whether a picture is draped over
/// the terrain.
bool is_heeded(const std::string& parameter, const Parameters& drawing, bool draped);

/// The legend of the settings' view over a terrain with these lowest and highest heights.
std::vector<Legend> legend_of(const ViewSettings& settings, double lowest_m, double highest_m);

}  // namespace talus::render
