#include "render/view.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "sim/error.h"

namespace talus::render {
namespace {

using Scale = Legend::Scale;
using Legends = std::vector<Legend>;

// From one side of 0 to the other.
Legends difference_legend(const View& view, const ViewSettings& settings, glm::dvec2) {
    const double most = view.numbers.front().in(settings);
    return {{"Ground since the start", -most, most, "m", Scale::difference}};
}

Legends bands_legend(const View& view, const ViewSettings& settings, glm::dvec2 heights_m) {
    const double band_m = view.numbers.front().in(settings);
    const auto band_of = [&](double height_m) { return static_cast<int>(std::floor(height_m / band_m)); };
    const int first = band_of(heights_m.x);
    const int last = band_of(heights_m.y);
    return {{"Height", first * band_m, (last + 1) * band_m, "m", Scale::map, last - first + 1}};
}

Legends contours_legend(const View& view, const ViewSettings& settings, glm::dvec2) {
    const double band_m = view.numbers.front().in(settings);
    return {{fmt::format("Contours: {:g} m, bold: {:g} m", band_m, 5 * band_m), 0, 0, "m", Scale::none}};
}

Legends level_legend(const View& view, const ViewSettings& settings, glm::dvec2) {
    const double middle_m = view.numbers[0].in(settings);
    const double range_m = view.numbers[1].in(settings);
    return {{"Level of the water", middle_m - range_m, middle_m + range_m, "m", Scale::difference}};
}

// So many powers of ten below the end of its scale.
Legends flow_legend(const View& view, const ViewSettings& settings, glm::dvec2) {
    const double end = std::log10(view.numbers[0].in(settings));
    return {{"Flow so far", end - view.numbers[1].in(settings), end, "log10 m³", Scale::map}};
}

Legends cells_legend(const View&, const ViewSettings& settings, glm::dvec2) {
    Legend legend{"Drawn by", 0, 0, "method", Scale::none};
    for (const PixelKind& one : method_named(settings.method).kinds(settings.numbers))
        legend.kinds.emplace_back(one.kind, one.words);
    return {legend};
}

Parameter band() {
    return number("render.band_m", 100, 1e-3, 1e5, "m", "Interval of the views of height bands and contours.")
        .labelled("Interval");
}

// It ends where what is there does, unless somebody sets it.
ViewNumber scale_end(const std::string& uniform, Parameter parameter, EndsScale ends = EndsScale::at_step) {
    parameter.help += " Unless set, it follows what is there, and stays while anything moves.";
    return {uniform, std::move(parameter), 0, false, false, ends};
}

ViewNumber depth_end() {
    return scale_end("depth_scale_m",
                     number("render.depth_m", 10, 1e-3, 1e5, "m",
                            "End of the scale of the views of the water's depth, now and at its largest.")
                         .labelled("Scale ends at"));
}

// What was taken, or laid down, by one of those who do, or by all.
View worn_view(const std::string& name, const std::string& title) {
    return {
        .name = name,
        .numbers = {scale_end("worn_scale_m", number("render.worn_m", 10, 1e-6, 1e5, "m",
                                                     "End of the scale of the views of wear and deposition.")
                                                  .labelled("Scale ends at")),
                    {"worn_by", choice("render.worn_by", "all", {"all", "water", "slopes", "hand"},
                                       "Whose wear and deposition they show.")
                                    .labelled("Worn by")}},
        .title = title,
        .unit = "m",
        .layers = {&Terrain::worn_by_water, &Terrain::worn_by_slopes, &Terrain::worn_by_hand}};
}

}  // namespace

const std::vector<View>& views() {
    static const std::vector<View> all = {
        {.name = "shaded",
         .numbers =
             {{"texture_taps",
               whole("render.texture_taps", 16, 1, 16, "",
                     "Places of a draped picture that a pixel looks at, where the view along the "
                     "ground draws it out: more are sharper.")
                   .labelled("Places a pixel"),
               0, true},
              {"snow_line_m",
               number("material.snow_line_m", 1350, -1e5, 1e5, "m",
                      "Height from which snow lies, where it is not too steep."),
               0, false, true},
              {"vegetation",
               number("material.vegetation", 1, 0, 1, "",
                      "How much of the ground that is not too steep is overgrown: 0, a desert."),
               0, false, true},
              {"rock_kind",
               choice("material.rock", "grey", {"grey", "red", "dark", "pale"},
                      "Colour of rock and scree: granite, sandstone, basalt, limestone."),
               0, false, true},
              {"masked_kind",
               choice("material.masked", "as elsewhere",
                      {"as elsewhere", "meadow", "forest", "rock", "scree", "sand", "snow"},
                      "What the ground is made of where the mask says so (panel Mask).")
                   .labelled("Where the mask is"),
               0, false, true},
              {"water_kind", choice("material.water", "mountain", {"mountain", "sea", "lagoon", "muddy"},
                                    "Colour of water.")},
              {"water_clarity",
               number("material.clarity", 1, 0.01, 100, "",
                      "How far one sees into water, times as far as in nature: less shows shallow water, as "
                      "in a basin of a laboratory.")}},
         .natural = true},
        {.name = "hillshade",
         .numbers = {{"hillshade_from",
                      choice(
                          "render.hillshade", "sun", {"sun", "four sides"},
                          "Light of the hillshade: the sun's, or from four sides, each where slopes need it.")
                          .labelled("Light from")}},
         .title = "Hillshade",
         .unit = "of full light",
         .scale = Scale::grey,
         .scale_end = 1},
        {.name = "slope",
         .numbers = {{"slope_scale_deg", std::nullopt, 60}},
         .title = "Slope",
         .unit = "degrees"},
        {.name = "bands", .label = "Height bands", .numbers = {{"band_m", band()}}, .legend = bands_legend},
        {.name = "steps",
         .label = "Steps of the ray",
         .numbers = {{"steps_scale", std::nullopt, 96}},
         .title = "Steps of the ray",
         .unit = "cells",
         .detail = Detail::steps,
         .sky_too = true},
        {.name = "cells", .label = "Method of each pixel", .legend = cells_legend, .detail = Detail::kind},
        {.name = "aspect",
         .title = "Slope faces",
         .unit = "degrees from north",
         .scale = Scale::direction,
         .scale_end = 360},
        {.name = "contours", .numbers = {{"band_m", band()}}, .legend = contours_legend},
        {.name = "difference",
         .label = "Ground since the start",
         .numbers = {scale_end("difference_m", number("render.difference_m", 20, 1e-3, 1e5, "m",
                                                      "End of the scale of the view of differences.")
                                                   .labelled("Scale ends at"))},
         .legend = difference_legend,
         .whole = true},
        {.name = "depth",
         .label = "Depth of the water",
         .numbers = {depth_end()},
         .title = "Depth of the water",
         .unit = "m",
         .layers = {&Terrain::water}},
        {.name = "speed",
         .label = "Speed of the water",
         .numbers = {scale_end("speed_scale", number("render.speed_m_per_s", 5, 1e-3, 1e5, "m/s",
                                                     "End of the scale of the view of its speed.")
                                                  .labelled("Scale ends at")
                                                  .once("render.speed"))},
         .title = "Speed of the water",
         .unit = "m/s",
         .layers = {&Terrain::water}},
        {.name = "level",
         .label = "Level of the water",
         .numbers = {{"level_middle_m",
                      number("render.level_m", 0, -1e6, 1e6, "m",
                             "Middle of the scale of the view of its level. Unless set, it is the sea's.")
                          .labelled("Scale around")},
                     scale_end("level_scale_m", number("render.level_range_m", 2, 1e-4, 1e5, "m",
                                                       "From there to the ends of the scale.")
                                                    .labelled("Scale reaches"))},
         .legend = level_legend,
         .layers = {&Terrain::water}},
        {.name = "froude",
         .label = "Froude number",
         .numbers = {{"froude_scale", std::nullopt, 2}},
         .title = "Froude number",
         .unit = "1: critical",
         .layers = {&Terrain::water}},
        {.name = "largest_depth",
         .numbers = {depth_end()},
         .title = "Largest depth so far",
         .unit = "m",
         .layers = {&Terrain::inundation}},
        {.name = "arrival",
         .label = "Arrival of the water",
         .numbers = {scale_end("arrival_scale_s",
                               number("render.arrival_s", 600, 1e-3, 1e9, "s",
                                      "End of the scale of the view of the time at which water arrived.")
                                   .labelled("Scale ends at"))},
         .title = "Water arrived at",
         .unit = "s",
         .layers = {&Terrain::inundation}},
        {.name = "hardness",
         .title = "Hardness",
         .unit = "1: does not erode",
         .scale_end = 1,
         .layers = {&Terrain::painted}},
        {.name = "mask", .title = "Mask", .unit = "share", .scale_end = 1, .layers = {&Terrain::painted}},
        {.name = "rain",
         .label = "Painted rain",
         .numbers = {scale_end("rain_scale", number("render.rain_mm_per_h", 200, 1e-3, 1e4, "mm/h",
                                                    "End of the scale of the view of painted rain.")
                                                 .labelled("Scale ends at")
                                                 .once("render.rain"))},
         .title = "Painted rain",
         .unit = "mm/h",
         .layers = {&Terrain::painted}},
        {.name = "manning",
         .label = "Painted roughness",
         .numbers = {scale_end("manning_scale", number("render.manning", 0.2, 1e-3, 1, "s/m^(1/3)",
                                                       "End of the scale of the view of painted roughness.")
                                                    .labelled("Scale ends at"))},
         .title = "Painted Manning's n",
         .unit = "s/m^(1/3)",
         .layers = {&Terrain::land_cover}},
        {.name = "infiltration",
         .label = "Painted infiltration",
         .numbers = {scale_end("infiltration_scale",
                               number("render.infiltration_mm_per_h", 100, 1e-3, 1e4, "mm/h",
                                      "End of the scale of the view of painted infiltration.")
                                   .labelled("Scale ends at"))},
         .title = "Painted infiltration",
         .unit = "mm/h",
         .layers = {&Terrain::land_cover}},
        {.name = "suspended",
         .label = "Suspended solid",
         .numbers = {scale_end(
             "suspended_scale_mm",
             number("render.suspended_mm", 20, 1e-6, 1e6, "mm",
                    "End of the scale of the view of suspended solid: as high as it would stand on the "
                    "ground.")
                 .labelled("Scale ends at"))},
         .title = "Suspended solid",
         .unit = "mm",
         .layers = {&Terrain::suspended}},
        {.name = "regolith",
         .numbers = {scale_end("regolith_scale_m", number("render.regolith_m", 5, 1e-6, 1e5, "m",
                                                          "End of the scale of the view of regolith.")
                                                       .labelled("Scale ends at"))},
         .title = "Regolith",
         .unit = "m",
         .whole = true},
        {.name = "flow",
         .numbers = {scale_end("flow_scale_m3",
                               number("render.flow_m3", 1e5, 1e-3, 1e15, "m³",
                                      "End of the scale of the view of flow.")
                                   .labelled("Scale ends at"),
                               EndsScale::at_power_of_ten),
                     {"flow_decades", std::nullopt, 4}},
         .legend = flow_legend,
         .layers = {&Terrain::flow}},
        worn_view("wear", "Wear"),
        worn_view("deposition", "Deposition"),
    };
    return all;
}

const View& view_named(const std::string& name) {
    const auto found =
        std::find_if(views().begin(), views().end(), [&](const View& view) { return view.name == name; });
    if (found == views().end()) throw Error("there is no view '" + name + "'");
    return *found;
}

double ViewNumber::in(const ViewSettings& settings) const {
    return parameter ? own_number(settings.numbers, *parameter) : fixed;
}

namespace {

// Those of all methods and views, each once: views may share one.
std::vector<Parameter> find_own_parameters() {
    std::vector<Parameter> all;
    for (const MethodEntry& method : methods())
        all.insert(all.end(), method.parameters.begin(), method.parameters.end());
    for (const View& view : views())
        for (const ViewNumber& one : view.numbers) {
            const bool known = one.parameter && std::any_of(all.begin(), all.end(), [&](const Parameter& p) {
                                   return p.name == one.parameter->name;
                               });
            if (one.parameter && !known) all.push_back(*one.parameter);
        }
    return all;
}

const std::vector<Parameter>& own_parameters() {
    static const std::vector<Parameter> all = find_own_parameters();
    return all;
}

}  // namespace

std::vector<Parameter> render_parameters() {
    std::vector<std::string> method_names;
    for (const MethodEntry& method : methods()) method_names.push_back(method.name);
    std::vector<std::string> view_names;
    std::vector<std::string> view_labels;
    for (const View& view : views()) {
        view_names.push_back(view.name);
        view_labels.push_back(view.label.empty() ? label_of_name(view.name) : view.label);
    }
    const ViewSettings preset;
    std::vector<Parameter> declared = {
        choice("render.method", preset.method, method_names, "How the surface is drawn.")
            .labelled("Drawn by"),
        number("render.tolerance_px", preset.tolerance_px, 0, 16, "px",
               "Error that the hybrid method or tiles may make, in pixels; 0: none.")
            .once("render.tolerance"),
        choice("render.view", preset.view, view_names, "What the colours show.")
            .labelled("Colours show")
            .choices_labelled(view_labels),
        number("render.sun_azimuth_deg", 315, 0, 360, "°", "Where the sun stands, clockwise from north.")
            .labelled("Sun from"),
        number("render.sun_elevation_deg", 38, 1, 90, "°", "How high the sun stands.").labelled("Sun above"),
        toggle("render.shadows", preset.shadows, "The sun casts shadows."),
        whole("render.samples", 8, 1, 64, "",
              "Samples a pixel, as many as a picture at rest gathers: smoother silhouettes and detail.")
            .labelled("Samples a pixel"),
        toggle("render.occlusion", preset.occlusion, "Valleys get less of the sky's light than ridges.")
            .labelled("Sky's light"),
    };
    for (const Parameter& own : own_parameters()) declared.push_back(own);
    return declared;
}

ViewSettings view_settings(const Parameters& drawing, const Parameters& simulation) {
    ViewSettings settings;
    settings.method = drawing.choice("render.method");
    settings.tolerance_px = drawing.number("render.tolerance_px");
    settings.view = drawing.choice("render.view");
    const double azimuth = drawing.number("render.sun_azimuth_deg") * std::numbers::pi / 180;
    const double elevation = drawing.number("render.sun_elevation_deg") * std::numbers::pi / 180;
    settings.sun = {std::sin(azimuth) * std::cos(elevation), std::cos(azimuth) * std::cos(elevation),
                    std::sin(elevation)};
    settings.shadows = drawing.toggle("render.shadows");
    settings.occlusion = drawing.toggle("render.occlusion");
    settings.gravity_m_per_s2 = simulation.number("water.gravity_m_per_s2");
    for (const Parameter& own : own_parameters())
        settings.numbers[own.name] = as_number(own, drawing.value(own.name));
    return settings;
}

bool is_heeded(const std::string& parameter, const Parameters& drawing, bool draped) {
    const auto is_it = [&](const Parameter& own) { return own.name == parameter; };
    const auto is_numbered = [&](const ViewNumber& one) {
        return one.parameter && is_it(*one.parameter) && (draped ? !one.of_bare : !one.of_drape);
    };
    const MethodEntry& method = method_named(drawing.choice("render.method"));
    const View& view = view_named(drawing.choice("render.view"));
    if (parameter == "render.tolerance_px") return method.heeds_tolerance;
    const std::vector<Parameter>& own = own_parameters();
    return std::none_of(own.begin(), own.end(), is_it) ||
           std::any_of(method.parameters.begin(), method.parameters.end(), is_it) ||
           std::any_of(view.numbers.begin(), view.numbers.end(), is_numbered);
}

std::vector<Legend> legend_of(const ViewSettings& settings, double lowest_m, double highest_m) {
    const View& view = view_named(settings.view);
    if (view.legend) return view.legend(view, settings, {lowest_m, highest_m});
    if (view.title.empty()) return {};
    const double end = view.scale_end ? *view.scale_end : view.numbers.front().in(settings);
    return {{view.title, 0, end, view.unit, view.scale}};
}

}  // namespace talus::render
