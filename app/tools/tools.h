#pragma once
#include <string>
#include <vector>

#include "sim/parameters.h"
#include "sim/passes/dab.h"
#include "sim/terrain/stamp.h"

namespace talus::app {

/// What a dab of a tool is made from.
struct ToolUse {
    const Parameters& parameters;
    bool inverted;       ///< Ctrl is held: it takes where it adds, wipes where it paints
    double ground_m;     ///< the height where the stroke began
    double wall_s;       ///< of wall time that the dab is worth
    const Stamp* stamp;  ///< null: none was chosen
};

/// How a stroke becomes dabs.
enum class StrokeCourse {
    by_time,  ///< dabs close to each other share the wall time
    stamps,   ///< one where it begins, then one a spacing further each, of whole effect
    at_end,   ///< one, from where it began to where it ends
    flows     ///< by time, with one strength and size from begin to end, and a last one that ends it
};

/// A tool of the brush: a line of `tools()`, and a file of this folder that makes it.
struct Tool {
    std::string name;    ///< the choice of brush.tool
    std::string icon;    ///< of its button (app/core/icon.h)
    std::string how_to;  ///< a sentence in the panel
    /// What it makes of a dab that has the brush's place, size and fading.
    void (*shape)(const ToolUse&, Dab&);
    std::vector<std::string> settings = {};  ///< names of the parameters that the panel shows with it
    std::string strength = "";               ///< the parameter that the keys - and = change; empty: none
    StrokeCourse course = StrokeCourse::by_time;
    bool limited_by_mask = true;    ///< brush.over holds for it
    bool picks_height = false;      ///< Ctrl and a click pick the height under the mouse
    std::string history_name = "";  ///< empty: as its dabs are called
    /// Its own, in a section that has its name.
    std::vector<Parameter> parameters = {};
};

/// All tools, in the order of their keys.
const std::vector<Tool>& tools();
/// The one of this name, which there must be.
const Tool& tool_named(const std::string& name);
std::vector<std::string> tool_names();

// app/tools/ground_tools.cpp
Tool raise_tool();
Tool lower_tool();
Tool smooth_tool();
Tool flatten_tool();
Tool height_tool();
Tool ramp_tool();
// one file each
Tool noise_tool();
Tool terrace_tool();
Tool stamp_tool();
Tool erode_tool();
// app/tools/paint_tools.cpp
Tool water_tool();
Tool rain_tool();
Tool hardness_tool();
Tool mask_tool();
Tool roughness_tool();
Tool infiltration_tool();

}  // namespace talus::app
