#pragma once
#include <string>
#include <vector>

#include "render/camera.h"
#include "sim/gpu/texture.h"
#include "sim/parameters.h"

namespace talus {

/// How the surface is coloured. The order is that of `view` in shaders/render/shade.frag and of view_names().
enum class View {
    shaded = 0,
    hillshade = 1,
    slope = 2,
    bands = 3,
    steps = 4,
    cells = 5,
    aspect = 6,
    contours = 7,
    difference = 8,
    depth = 9,  // from here on of the water
    speed = 10,
    level = 11,
    froude = 12,
    largest = 13,
    arrival = 14,
    hardness = 15,  // from here on of what brushes painted
    mask = 16,
    rain = 17,
    suspended = 18,
    regolith = 19
};
const std::vector<std::string>& view_names();

/// What a view's colours mean: a title with unit, and the values at the scale's ends.
struct Legend {
    std::string title;
    double low = 0;
    double high = 0;
    std::string unit;
    enum class Scale { map, grey, direction, difference, none } scale = Scale::map;
    int bands = 0;  ///< a scale of so many flat steps; 0: smooth
    /// Instead of a scale: what single colours mean, by kind (render/methods/method.h).
    std::vector<std::pair<double, std::string>> kinds;
};

/// The parameters of drawing (law 8): they change the picture, never the terrain.
std::vector<Parameter> render_parameters();

/// What lies on the ground under the mouse: a brush's ring, or a stamp as it would be pressed.
struct Ring {
    glm::dvec2 at_m{0};
    double radius_m = 0;                  ///< 0: nothing lies there
    const gpu::Texture* stamp = nullptr;  ///< heights, 0 to 1; none: a ring
    glm::dvec2 stamp_columns{0};          ///< of the stamp, a metre east and north, from its middle
    glm::dvec2 stamp_rows{0};
    bool operator==(const Ring&) const = default;
};

/// What the renderer takes from those parameters.
struct ViewSettings {
    std::string method = "hybrid";
    double tolerance_px = 0.5;
    View view = View::shaded;
    glm::dvec3 sun{0, 0, 1};  ///< unit vector towards the sun: east, north, up
    bool shadows = true;
    bool occlusion = true;
    double band_m = 100;
    double difference_m = 20;
    double depth_m = 10;  ///< views of the water: ends of their scales
    double speed_m_per_s = 5;
    double level_m = 0;        ///< the middle of the levels' scale
    double level_range_m = 2;  ///< from the middle to its ends
    double arrival_s = 600;
    double rain_mm_per_h = 200;
    double suspended_mm = 20;
    double regolith_m = 5;
    int hillshade_lights = 1;
    /// Leaves out what is costly and little missed where frames are late: shadows, and ground that water
    /// mirrors.
    bool quick = false;
    Ring ring;
    bool operator==(const ViewSettings&) const = default;
};
ViewSettings view_settings(const Parameters& parameters);

/// The legend of a view over a terrain with these lowest and highest heights; none for `shaded`.
std::vector<Legend> legend_of(const ViewSettings& settings, double lowest_m, double highest_m);

constexpr double slope_scale_deg = 60;
constexpr double steps_scale = 96;
constexpr double froude_scale = 2;

}  // namespace talus
