#include "app/core/erosion_controls.h"

#include <algorithm>
#include <cmath>

#include "sim/passes/water_settings.h"

namespace talus::app {
namespace {

// Numbers that people can read: to three digits.
double rounded(double value) {
    if (value <= 0) return 0;
    const double digit = std::pow(10.0, std::floor(std::log10(value)) - 2);
    return std::round(value / digit) * digit;
}

// The value that an assignment gives.
Value assigned(const std::string& assignment, const Parameters& like, std::string& name) {
    Parameters one = like;
    one.set_assignment(assignment);
    name = assignment.substr(0, assignment.find('='));
    return one.value(name);
}

}  // namespace

const std::vector<ErosionControl>& erosion_controls() {
    static const std::vector<ErosionControl> all = {
        {"Strength",
         "weak",
         "strong",
         "How much the water takes: erodibility of loose ground, and of rock by the same factor.",
         {"erosion.erodibility", "erosion.bedrock_erodibility"},
         0.2,
         200},
        {"Age",
         "young",
         "old",
         "How much of geological time a storm stands for: how often each exchange with the ground counts.",
         {"erosion.acceleration"},
         1,
         1000},
        {"Scale of valleys",
         "gullies",
         "wide valleys",
         "How much water must gather before it cuts: the critical shear stress. A small one lets every slope "
         "be cut, a large one leaves broad ridges between few valleys.",
         {"erosion.critical_shear_pa"},
         1,
         1000},
        {"Sediment",
         "washed away",
         "piles up",
         "How soon what was taken comes to rest: the speed at which grains settle. Much of it fills valleys "
         "and builds fans.",
         {"erosion.settling_mm_per_s"},
         0.1,
         1000}};
    return all;
}

double position_of(const ErosionControl& control, const Parameters& parameters) {
    const double value = parameters.number(control.parameters.front());
    if (value <= control.from) return 0;
    return std::min(1.0, std::log(value / control.from) / std::log(control.to / control.from));
}

std::vector<SetParameter> moved_to(const ErosionControl& control, double position,
                                   const Parameters& parameters) {
    const double before = parameters.number(control.parameters.front());
    const double lead = control.from * std::pow(control.to / control.from, std::clamp(position, 0.0, 1.0));
    std::vector<SetParameter> changes;
    for (const std::string& name : control.parameters) {
        const Parameter& p = parameters.declaration(name);
        // Of what was 0 no factor is known: it stays.
        const bool leads = name == control.parameters.front();
        const double factor = before > 0 ? lead / before : 1;
        const double value = leads ? lead : parameters.number(name) * factor;
        changes.push_back({name, Value(std::clamp(rounded(value), p.low, p.high))});
    }
    return changes;
}

const std::vector<ErosionPreset>& climates() {
    static const std::vector<ErosionPreset> all = {
        {"Drizzle",
         "Gentle rain, a third of which seeps away.",
         {"water.rain_mm_per_h=600", "water.infiltration_mm_per_h=200", "thermal.weathering_mm_per_h=0"}},
        {"Rainstorm",
         "A strong storm of the temperate zone.",
         {"water.rain_mm_per_h=1500", "water.infiltration_mm_per_h=0", "thermal.weathering_mm_per_h=0"}},
        {"Monsoon",
         "Rain as heavy as it gets.",
         {"water.rain_mm_per_h=4000", "water.infiltration_mm_per_h=0", "thermal.weathering_mm_per_h=0"}},
        {"Desert storm",
         "A cloudburst on ground that drinks: rivers lose their water on the way.",
         {"water.rain_mm_per_h=2500", "water.infiltration_mm_per_h=800", "thermal.weathering_mm_per_h=0"}},
        {"Frost and melt",
         "Frost loosens bare rock, and meltwater carries it off.",
         {"water.rain_mm_per_h=1000", "water.infiltration_mm_per_h=0", "thermal.weathering_mm_per_h=4000"}}};
    return all;
}

const std::vector<ErosionPreset>& rocks() {
    static const std::vector<ErosionPreset> all = {
        {"Granite",
         "Hard, and stands steep; its debris is coarse.",
         {"erosion.bedrock_erodibility=0.5", "erosion.erodibility=20", "thermal.bedrock_deg=70",
          "thermal.repose_deg=36", "erosion.strata_m=0"}},
        {"Limestone",
         "Steep walls that water cuts slowly.",
         {"erosion.bedrock_erodibility=1.5", "erosion.erodibility=20", "thermal.bedrock_deg=75",
          "thermal.repose_deg=35", "erosion.strata_m=0"}},
        {"Layered sandstone",
         "Hard and soft layers by turns: steps and ledges.",
         {"erosion.bedrock_erodibility=6", "erosion.erodibility=20", "thermal.bedrock_deg=65",
          "thermal.repose_deg=34", "erosion.strata_m=40", "erosion.strata_hardness=0.8"}},
        {"Shale",
         "Soft, and falls apart into flat debris.",
         {"erosion.bedrock_erodibility=10", "erosion.erodibility=30", "thermal.bedrock_deg=42",
          "thermal.repose_deg=30", "erosion.strata_m=0"}},
        {"Ash and loess",
         "Hardly rock at all: gullies within a storm, and steep banks.",
         {"erosion.bedrock_erodibility=40", "erosion.erodibility=80", "thermal.bedrock_deg=60",
          "thermal.repose_deg=32", "erosion.strata_m=0"}}};
    return all;
}

std::vector<SetParameter> settings_of(const ErosionPreset& preset, const Parameters& parameters,
                                      const Grid& grid) {
    std::vector<SetParameter> changes;
    for (const std::string& assignment : preset.assignments) {
        SetParameter set;
        set.value = assigned(assignment, parameters, set.name);
        changes.push_back(std::move(set));
    }
    const auto is_climate = std::any_of(climates().begin(), climates().end(),
                                        [&](const ErosionPreset& one) { return one.name == preset.name; });
    if (!is_climate) return changes;
    changes.push_back({"erosion.on", Value(true)});
    changes.push_back({"water.on", Value(true)});
    // Stress, and so erosion, follows the bed's roughness.
    if (parameters.number("water.manning") <= 0) changes.push_back({"water.manning", Value(0.05)});
    // What nobody set is as in the preset rain-erosion, in more time, so that a storm's work is seen.
    for (const char* assignment :
         {"erosion.acceleration=300", "erosion.erodibility=20", "erosion.bedrock_erodibility=4",
          "erosion.critical_shear_pa=20", "erosion.settling_mm_per_s=30", "erosion.porosity=0.3"}) {
        SetParameter set;
        set.value = assigned(assignment, parameters, set.name);
        if (!parameters.is_given(set.name)) changes.push_back(std::move(set));
    }
    constexpr double longest_tick_s = 0.5;
    constexpr double samples_a_second = 30;
    if (!parameters.is_given("time.tick_s"))
        changes.push_back({"time.tick_s", Value(rounded(std::min(longest_tick_s, std::min(grid.dx, grid.dy) /
                                                                                     samples_a_second)))});
    return changes;
}

const ErosionPreset* present_of(const std::vector<ErosionPreset>& presets, const Parameters& parameters) {
    const auto found = std::find_if(presets.begin(), presets.end(), [&](const ErosionPreset& one) {
        return std::all_of(one.assignments.begin(), one.assignments.end(),
                           [&](const std::string& assignment) {
                               std::string name;
                               const Value value = assigned(assignment, parameters, name);
                               return parameters.value(name) == value;
                           });
    });
    return found == presets.end() ? nullptr : &*found;
}

std::string why_nothing_erodes(const Parameters& parameters, bool is_wet, bool is_painted) {
    if (!parameters.toggle("erosion.on")) return "";
    if (!parameters.toggle("water.on")) return "Nothing erodes: the water is off.";
    if (parameters.number("water.manning") <= 0)
        return "Nothing erodes: Manning's n is 0, so the water shears no bed.";
    if (parameters.choice("erosion.over") == "mask" && !is_painted)
        return "Nothing erodes: erosion follows the mask, and none was made.";
    bool comes =
        parameters.number("water.rain_mm_per_h") > 0 || parameters.number("water.inflow_m3_per_s") > 0;
    for (const Edge edge : {Edge::north, Edge::south, Edge::west, Edge::east}) {
        const std::string& kind = parameters.choice(boundary_parameter(edge));
        comes = comes || kind == "level" || kind == "wave";
    }
    if (!comes && !is_wet) return "Nothing erodes: there is no water. Choose a climate, or paint rain.";
    return "";
}

}  // namespace talus::app
