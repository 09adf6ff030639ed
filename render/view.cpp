#include "render/view.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>

#include "render/methods/method.h"

namespace talus {
namespace {

std::string number_text(double value) {
    std::ostringstream text;
    text << value;
    return text.str();
}

}  // namespace

const std::vector<std::string>& view_names() {
    static const std::vector<std::string> names = {
        "shaded",   "hillshade",  "slope", "bands", "steps",     "cells",   "aspect",
        "contours", "difference", "depth", "speed", "level",     "froude",  "largest_depth",
        "arrival",  "hardness",   "mask",  "rain",  "suspended", "regolith"};
    return names;
}

std::vector<Parameter> render_parameters() {
    std::vector<std::string> method_names;
    for (const MethodEntry& method : methods()) method_names.push_back(method.name);
    return {
        choice("render.method", "hybrid", method_names, "How the surface is drawn."),
        number("render.tolerance", 0.5, 0, 16, "px",
               "Error that the hybrid method may make, in pixels; 0: none, rays everywhere."),
        choice("render.view", "shaded", view_names(), "What the colours show."),
        number("render.sun_azimuth_deg", 315, 0, 360, "°", "Where the sun stands, clockwise from north."),
        number("render.sun_elevation_deg", 38, 1, 90, "°", "How high the sun stands."),
        toggle("render.shadows", true, "The sun casts shadows."),
        whole("render.samples", 8, 1, 64, "",
              "Samples a pixel, as many as a picture at rest gathers: smoother silhouettes and detail."),
        toggle("render.occlusion", true, "Valleys get less of the sky's light than ridges."),
        number("render.band_m", 100, 1e-3, 1e5, "m", "Interval of the views of height bands and contours."),
        number("render.difference_m", 20, 1e-3, 1e5, "m", "End of the scale of the view of differences."),
        number("render.depth_m", 10, 1e-3, 1e5, "m",
               "End of the scale of the views of the water's depth, now and at its largest."),
        number("render.speed", 5, 1e-3, 1e5, "m/s", "End of the scale of the view of its speed."),
        number("render.level_m", 0, -1e6, 1e6, "m",
               "Middle of the scale of the view of its level. Unless set, it is the sea's."),
        number("render.level_range_m", 2, 1e-4, 1e5, "m", "From there to the ends of the scale."),
        number("render.arrival_s", 600, 1e-3, 1e9, "s",
               "End of the scale of the view of the time at which water arrived."),
        number("render.rain", 200, 1e-3, 1e4, "mm/h", "End of the scale of the view of painted rain."),
        number("render.suspended_mm", 20, 1e-6, 1e6, "mm",
               "End of the scale of the view of suspended solid: as high as it would stand on the ground."),
        number("render.regolith_m", 5, 1e-6, 1e5, "m", "End of the scale of the view of regolith."),
        choice("render.hillshade", "sun", {"sun", "four sides"},
               "Light of the hillshade: the sun's, or from four sides, each where slopes need it."),
    };
}

ViewSettings view_settings(const Parameters& parameters) {
    ViewSettings settings;
    settings.method = parameters.choice("render.method");
    settings.tolerance_px = parameters.number("render.tolerance");
    const auto& names = view_names();
    settings.view = static_cast<View>(
        std::find(names.begin(), names.end(), parameters.choice("render.view")) - names.begin());
    const double azimuth = parameters.number("render.sun_azimuth_deg") * std::numbers::pi / 180;
    const double elevation = parameters.number("render.sun_elevation_deg") * std::numbers::pi / 180;
    settings.sun = {std::sin(azimuth) * std::cos(elevation), std::cos(azimuth) * std::cos(elevation),
                    std::sin(elevation)};
    settings.shadows = parameters.toggle("render.shadows");
    settings.occlusion = parameters.toggle("render.occlusion");
    settings.band_m = parameters.number("render.band_m");
    settings.difference_m = parameters.number("render.difference_m");
    settings.depth_m = parameters.number("render.depth_m");
    settings.speed_m_per_s = parameters.number("render.speed");
    settings.level_m = parameters.number("render.level_m");
    settings.level_range_m = parameters.number("render.level_range_m");
    settings.arrival_s = parameters.number("render.arrival_s");
    settings.rain_mm_per_h = parameters.number("render.rain");
    settings.suspended_mm = parameters.number("render.suspended_mm");
    settings.regolith_m = parameters.number("render.regolith_m");
    settings.hillshade_lights = parameters.choice("render.hillshade") == "sun" ? 1 : 4;
    return settings;
}

std::vector<Legend> legend_of(const ViewSettings& settings, double lowest_m, double highest_m) {
    const auto band_of = [&](double height_m) {
        return static_cast<int>(std::floor(height_m / settings.band_m));
    };
    using Scale = Legend::Scale;
    switch (settings.view) {
        case View::shaded:
            return {};
        case View::hillshade:
            return {{"Hillshade", 0, 1, "of full light", Scale::grey, 0, {}}};
        case View::slope:
            return {{"Slope", 0, slope_scale_deg, "degrees", Scale::map, 0, {}}};
        case View::bands:
            return {{"Height",
                     band_of(lowest_m) * settings.band_m,
                     (band_of(highest_m) + 1) * settings.band_m,
                     "m",
                     Scale::map,
                     band_of(highest_m) - band_of(lowest_m) + 1,
                     {}}};
        case View::steps:
            return {{"Steps of the ray", 0, steps_scale, "cells", Scale::map, 0, {}}};
        case View::cells:
            return {{"Drawn by",
                     0,
                     0,
                     "method",
                     Scale::none,
                     0,
                     {{1, "mesh"},
                      {2, "rays to the patch"},
                      {4, "rays ended at level 2"},
                      {8, "rays ended at level 6"}}}};
        case View::aspect:
            return {{"Slope faces", 0, 360, "degrees from north", Scale::direction, 0, {}}};
        case View::contours:
            return {{"Contours: " + number_text(settings.band_m) +
                         " m, bold: " + number_text(5 * settings.band_m) + " m",
                     0,
                     0,
                     "m",
                     Scale::none,
                     0,
                     {}}};
        case View::difference:
            return {{"Ground since the start",
                     -settings.difference_m,
                     settings.difference_m,
                     "m",
                     Scale::difference,
                     0,
                     {}}};
        case View::depth:
            return {{"Depth of the water", 0, settings.depth_m, "m", Scale::map, 0, {}}};
        case View::speed:
            return {{"Speed of the water", 0, settings.speed_m_per_s, "m/s", Scale::map, 0, {}}};
        case View::level:
            return {{"Level of the water",
                     settings.level_m - settings.level_range_m,
                     settings.level_m + settings.level_range_m,
                     "m",
                     Scale::difference,
                     0,
                     {}}};
        case View::froude:
            return {{"Froude number", 0, froude_scale, "1: critical", Scale::map, 0, {}}};
        case View::largest:
            return {{"Largest depth so far", 0, settings.depth_m, "m", Scale::map, 0, {}}};
        case View::arrival:
            return {{"Water arrived at", 0, settings.arrival_s, "s", Scale::map, 0, {}}};
        case View::hardness:
            return {{"Hardness", 0, 1, "1: does not erode", Scale::map, 0, {}}};
        case View::mask:
            return {{"Mask", 0, 1, "share", Scale::map, 0, {}}};
        case View::suspended:
            return {{"Suspended solid", 0, settings.suspended_mm, "mm", Scale::map, 0, {}}};
        case View::regolith:
            return {{"Regolith", 0, settings.regolith_m, "m", Scale::map, 0, {}}};
        case View::rain:
            return {{"Painted rain", 0, settings.rain_mm_per_h, "mm/h", Scale::map, 0, {}}};
    }
    return {};
}

}  // namespace talus
