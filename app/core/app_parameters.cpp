#include "app/core/app_parameters.h"

#include "app/core/path_draft.h"
#include "app/tools/tools.h"
#include "render/view.h"
#include "sim/passes/brush.h"
#include "sim/passes/mask_settings.h"
#include "sim/simulation_parameters.h"

namespace talus::app {

namespace {

// But for the rectangle: it is drawn.
std::vector<std::string> sources_of_masks() {
    std::vector<std::string> names = mask_source_names();
    names.pop_back();
    return names;
}

}  // namespace

std::vector<Parameter> app_parameters() {
    std::vector<Parameter> all = {
        choice(
            "brush.tool", "raise", tool_names(),
            "What a stroke does. Flatten: to the height where it began; height: to brush.height_m; ramp: a "
            "slope from where it begins to where it ends; water, rain, hardness, mask, roughness and "
            "infiltration: put there, with Ctrl taken away; erode: rain that falls under the brush alone "
            "carves the ground. Ctrl turns raise "
            "and lower, noise and stamps around; Shift smooths with any tool."),
        number("brush.radius_m", 250, 1e-2, 1e6, "m",
               "Reach of the brush; unless set, it follows the terrain's size, or over tiles the height."),
        number("brush.rate_m_per_s", 60, 0, 1e6, "m/s",
               "Raise, lower, noise and water: metres a second in the middle; unless set, it follows the "
               "terrain's "
               "size.")
            .labelled("Rate"),
        number(
            "brush.blend_per_s", 4, 0, 1000, "1/s",
            "Smooth, flatten, height, terrace and what is painted: share of the way a second in the middle.")
            .labelled("Strength"),
        number("brush.falloff", Dab().falloff, 0, 1, "",
               "How much of the radius fades out: 0 a hard edge, 1 soft all the way.")
            .labelled("Softness"),
        choice("brush.curve", Dab().curve, falloff_curve_names(),
               "How it fades: smooth, linear, round like a ball, sharp like a thorn.")
            .labelled("Fades"),
        number("brush.spacing", 0.25, 0.02, 4, "",
               "Way between two dabs of a stroke, in radii; stamps: between two of them."),
        number("brush.jitter", 0, 0, 4, "", "How far dabs scatter about the stroke, in radii."),
        whole("brush.seed", 1, 0, 1000000, "", "Another seed scatters otherwise."),
        choice("brush.over", "everywhere", {"everywhere", "mask"},
               "Where the brush acts; by the mask: as far as it says.")
            .labelled("Brush where"),
        choice("brush.material", "bedrock", {"bedrock", "regolith"}, "What raising adds."),
        number("brush.height_m", 0, -1e6, 1e6, "m",
               "Tool height: the height that it brings the ground to; Ctrl and a click pick it.")
            .labelled("Height"),
        number("brush.rain_mm_per_h", 100, 0, 1e4, "mm/h", "Rain that the tool rain paints.")
            .labelled("Rain")
            .once("brush.rain"),
        number("brush.value", 1, 0, 1, "", "Hardness or mask that the tools of this name paint.")
            .labelled("Value"),
        number("brush.manning", 0.1, 0, description_of(PaintedNumber::manning).most, "s/m^(1/3)",
               "Manning's n that the tool roughness paints: 0.03 a natural stream, 0.1 a wooded flood plain.")
            .labelled("Manning's n"),
        number("brush.infiltration_mm_per_h", 20, 0, description_of(PaintedNumber::infiltration).most, "mm/h",
               "Infiltration that its tool paints: 2 clay, 20 loam, 100 sand.")
            .labelled("Infiltration")};
    for (const Tool& tool : tools()) all.insert(all.end(), tool.parameters.begin(), tool.parameters.end());
    const std::vector<Parameter> paths = path_parameters();
    all.insert(all.end(), paths.begin(), paths.end());
    const std::vector<Parameter> others = {
        whole("map.nx", 513, min_samples, max_samples, "samples",
              "Resample: columns; unless set, as many as there are.")
            .labelled("Samples to the east"),
        whole("map.ny", 513, min_samples, max_samples, "samples",
              "Resample: rows; unless set, as many as there are.")
            .labelled("Samples to the north"),
        number("map.offset_m", 0, -1e5, 1e5, "m", "Whole map: added to every height.").labelled("Raise by"),
        number("map.scale", 1, 0, 100, "", "Whole map: times the height above map.base_m.")
            .labelled("Scale by"),
        number("map.base_m", 0, -1e6, 1e6, "m", "Whole map: the height that scaling keeps.")
            .labelled("Scale above"),
        number("map.noise_m", 100, 0, 1e5, "m", "Whole map: height of the noise that is added.")
            .labelled("Height of noise"),
        number("map.blur_m", 20, 1e-3, 1e6, "m", "Whole map: standard deviation of the blur.")
            .labelled("Blur over"),
        number("map.west_m", 0, -1e8, 1e8, "m", "Crop and cut out: western edge, from the south-west sample.")
            .labelled("Western edge"),
        number("map.south_m", 0, -1e8, 1e8, "m", "Crop and cut out: southern edge.")
            .labelled("Southern edge"),
        number("map.east_m", 0, -1e8, 1e8, "m", "Crop and cut out: eastern edge.").labelled("Eastern edge"),
        number("map.north_m", 0, -1e8, 1e8, "m", "Crop and cut out: northern edge.")
            .labelled("Northern edge"),
        number("map.feather_m", 0, 0, 1e6, "m",
               "Put back: so far from the cut-out's edges work fades into what it was cut out of.")
            .labelled("Fades over"),
        choice(
            "mask.from", MaskSettings().source, sources_of_masks(),
            "What a mask is made of: height, slope, curvature (crests above 0, hollows below); depth of "
            "water, now or at its largest, and when it arrived (s); flow (m³); wear, deposition, regolith, "
            "the ground's difference from the start; the mask itself (to invert it), everything.")
            .labelled("Mask from"),
        number("mask.low", 30, -1e12, 1e12, "m, °, 1/km, s or m³", "The mask is 1 from here …")
            .labelled("From"),
        number("mask.high", 90, -1e12, 1e12, "m, °, 1/km, s or m³", "… to here …").labelled("To"),
        number("mask.fade", 5, 0, 1e12, "m, °, 1/km, s or m³", "… and falls to 0 over so much beyond each.")
            .labelled("Fades over"),
        choice("mask.join", MaskSettings().join, mask_join_names(),
               "It takes the place of the painted mask, is added to it, keeps what both have, or is taken "
               "away.")
            .labelled("Joined"),
        toggle("mask.inverted", MaskSettings().inverted, "1 where it would be 0."),
        number("mask.blur_m", 50, 1e-3, 1e6, "m", "Standard deviation of a blur of the mask.")
            .labelled("Blur over"),
        number("spring.rate_m3_per_s", 10, 1e-6, 1e6, "m³/s", "Rate of the next spring that is placed.")
            .labelled("Spring gives"),
        choice("camera.mode", "orbit", {"orbit", "fly", "walk", "top"},
               "Orbit turns about a point on the ground; fly moves with W A S D, Q and E; walk keeps the eye "
               "over the ground; top looks straight down with parallel rays, as a map does.")
            .labelled("Camera"),
        number("camera.eye_height_m", 1.8, 1e-2, 1e4, "m", "Walking: the eye over the ground.")
            .labelled("Height of the eye"),
        number("camera.walk_m_per_s", 10, 1e-2, 1e6, "m/s", "Walking: speed.").labelled("Walking speed"),
        toggle("camera.collision", true,
               "The ground stops the camera; off: it may go below, where the ground is solid.")
            .labelled("Ground stops it"),
        number("camera.fov_deg", 50, 5, 120, "°", "Vertical field of view.").labelled("Field of view"),
        number("camera.speed_m_per_s", 500, 1e-2, 1e6, "m/s",
               "Speed of flying; unless set, it follows the terrain's size.")
            .labelled("Flying speed"),
        number("time.speed", 1, 1e-3, 1e6, "s/s", "Simulated seconds a second of play."),
        number("autosave.interval_s", 120, 1, 86400, "s",
               "Unsaved work is kept by itself so often, for the case that Talus ends unexpectedly.")
            .labelled("Autosave every")
            .of_this_machine(),
        whole(
            "tiles.gpu_mib", 128, 32, 1 << 16, "MiB",
            "Memory of the device that heights in tiles may take; where the view needs more, it is coarser.")
            .labelled("Heights on device")
            .of_this_machine(),
        whole("tiles.photo_mib", 128, 16, 1 << 16, "MiB",
              "Memory of the device that tiles of a photo over the terrain may take; where the view needs "
              "more, it is coarser.")
            .labelled("Photo on device")
            .of_this_machine(),
        whole("tiles.host_mib", 512, 16, 1 << 20, "MiB",
              "Memory that reading files in tiles may keep of them.")
            .labelled("Reading")
            .of_this_machine(),
        toggle("tiles.backdrop", true, "Around a terrain that was cut out of a raster stands the rest of it.")
            .labelled("Show the rest"),
        whole("undo.memory_mib", 1024, 1, 1 << 20, "MiB",
              "Memory that the history may take, packed; the oldest acts go first.")
            .labelled("History")
            .of_this_machine(),
    };
    all.insert(all.end(), others.begin(), others.end());
    return all;
}

std::vector<Parameter> all_parameters() {
    std::vector<Parameter> all = simulation_parameters();
    for (auto& more : {render::render_parameters(), app_parameters()})
        all.insert(all.end(), more.begin(), more.end());
    return all;
}

}  // namespace talus::app
