#include "sim/passes/water_settings.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sim/passes/map_settings.h"

namespace talus {
namespace {

BoundParameter<WaterSettings> boundary(Edge edge, const char* label, const char* help) {
    const std::string& name = boundary_parameter(edge);
    Parameter declared =
        choice(name, WaterSettings().edges[static_cast<std::size_t>(edge)], edge_kinds(), help)
            .setting_off(SetsOff::edge_clock)
            .labelled(label);
    return {std::move(declared), [=](const Parameters& parameters, WaterSettings& settings) {
                settings.edges[static_cast<std::size_t>(edge)] = parameters.choice_as<EdgeKind>(name);
            }};
}

}  // namespace

const std::string& boundary_parameter(Edge edge) {
    static const std::array<std::string, 4> names = {"water.boundary.north", "water.boundary.south",
                                                     "water.boundary.west", "water.boundary.east"};
    return names[static_cast<std::size_t>(edge)];
}

std::string turned_edge_parameter(const std::string& name, int quarters) {
    // What was east is north after a quarter.
    constexpr std::array around = {Edge::east, Edge::north, Edge::west, Edge::south};
    const auto turned = static_cast<std::size_t>((quarters % 4 + 4) % 4);
    for (std::size_t i = 0; i < 4; ++i)
        if (name == boundary_parameter(around[i])) return boundary_parameter(around[(i + turned) % 4]);
    return name;
}

void turn_edges(Parameters& parameters, int quarters) {
    const Parameters before = parameters;
    for (const Edge edge : {Edge::north, Edge::south, Edge::west, Edge::east}) {
        const std::string& name = boundary_parameter(edge);
        const std::string to = turned_edge_parameter(name, quarters);
        const Value& from = before.value(name);
        if (from != before.value(to)) parameters.set(to, from);
    }
}

const std::vector<BoundParameter<WaterSettings>>& water_parameters() {
    constexpr double mm_per_h = 1e-3 / 3600;
    static const WaterSettings preset;
    static const std::vector<BoundParameter<WaterSettings>> table = {
        unbound<WaterSettings>(
            toggle("water.on", true, "Water flows. Where there is none, and none comes, it costs nothing.")
                .labelled("Water on")),
        bound(whole("water.order", preset.order, 1, 2, "",
                    "Order of the scheme: 1 is cheaper, 2 far more exact.")
                  .labelled("Order of scheme"),
              &WaterSettings::order),
        bound(number("water.gravity_m_per_s2", preset.gravity_m_per_s2, 0.01, 100, "m/s²",
                     "Acceleration of gravity.")
                  .once("water.gravity"),
              &WaterSettings::gravity_m_per_s2),
        bound(
            number("water.manning", preset.manning_s_per_m13, 0, 1, "s/m^(1/3)",
                   "Manning's roughness of the bed: 0 none, 0.03 a natural stream, 0.1 a wooded flood plain.")
                .labelled("Manning's n"),
            &WaterSettings::manning_s_per_m13),
        bound(number("water.rain_mm_per_h", preset.rain_m_per_s / mm_per_h, 0, 1e4, "mm/h",
                     "Rain: everywhere, or by the mask; what a brush of rain painted falls besides.")
                  .once("water.rain")
                  .following_tables(Driven::within_tick),
              &WaterSettings::rain_m_per_s, mm_per_h),
        bound(choice("water.rain_over", preset.rain_masked, {"everywhere", "mask"},
                     "Where water.rain falls; by the mask: as much of it as the mask says.")
                  .labelled("Rain where"),
              &WaterSettings::rain_masked),
        bound(number("water.infiltration_mm_per_h", preset.infiltration_m_per_s / mm_per_h, 0, 1e4, "mm/h",
                     "Water that the ground takes in, where there is any.")
                  .once("water.infiltration"),
              &WaterSettings::infiltration_m_per_s, mm_per_h),
        bound(number("water.evaporation_mm_per_h", preset.evaporation_m_per_s / mm_per_h, 0, 1e4, "mm/h",
                     "Water that the air takes, where there is any.")
                  .once("water.evaporation"),
              &WaterSettings::evaporation_m_per_s, mm_per_h),
        bound(number(
                  "water.sea_level_m", preset.level_m, -1e6, 1e6, "m",
                  "Level of the sea. When set, it fills what lies lower and is connected to the map's edge, "
                  "and "
                  "stands beyond open edges; edges of kind level hold it, and it is the still level of edges "
                  "of kind wave.")
                  .once("water.sea_level")
                  .setting_off(SetsOff::sea)
                  .following_tables(Driven::within_tick),
              &WaterSettings::level_m),
        boundary(Edge::north, "Northern edge",
                 "Northern edge: a wall, open (waves leave), a held level, an inflow, a wave maker, or "
                 "periodic (joined to the opposite edge, whatever that is set to)."),
        boundary(Edge::south, "Southern edge", "Southern edge, as the northern one."),
        boundary(Edge::west, "Western edge", "Western edge, as the northern one."),
        boundary(Edge::east, "Eastern edge", "Eastern edge, as the northern one."),
        bound(number("water.inflow_m3_per_s", preset.inflow_m3_per_s, 0, 1e9, "m³/s",
                     "Discharge through all edges of kind inflow together, at its peak, each by its length.")
                  .once("water.inflow")
                  .setting_off(SetsOff::edge_clock)
                  .following_tables(Driven::within_tick),
              &WaterSettings::inflow_m3_per_s),
        bound(choice(
                  "water.inflow_over", preset.inflow_by_conveyance, {"evenly", "conveyance"},
                  "How it spreads along an edge: evenly, or as the ground there conveys it, by depth^(5/3) / "
                  "Manning's n under one level; then it comes in through the valleys.")
                  .labelled("Inflow spreads"),
              &WaterSettings::inflow_by_conveyance),
        bound(number("water.inflow_slope", preset.inflow_slope, 1e-6, 1, "",
                     "Slope of the river beyond the edge, for the level that water.inflow_over = conveyance "
                     "goes by.")
                  .labelled("Slope beyond edge"),
              &WaterSettings::inflow_slope),
        bound(number("water.inflow_rise_s", preset.inflow_rise_s, 0, 1e9, "s",
                     "Time that the inflow takes from nothing to its peak.")
                  .labelled("Inflow rises in")
                  .once("water.inflow_rise")
                  .setting_off(SetsOff::edge_clock),
              &WaterSettings::inflow_rise_s),
        bound(number("water.inflow_fall_s", preset.inflow_fall_s, 0, 1e9, "s",
                     "Time that it takes from the peak back to nothing; 0: it stays at its peak.")
                  .labelled("Inflow falls in")
                  .once("water.inflow_fall")
                  .setting_off(SetsOff::edge_clock),
              &WaterSettings::inflow_fall_s),
        bound(choice("water.wave", preset.wave_form, {"sine", "solitary", "series"},
                     "What the wave maker sends; series: what the table of water.wave_height_m says, and "
                     "nothing without one.")
                  .labelled("Wave maker")
                  .setting_off(SetsOff::edge_clock),
              &WaterSettings::wave_form),
        bound(number("water.wave_height_m", preset.wave_height_m, -1e4, 1e4, "m",
                     "Sine: amplitude about the still level. Solitary: crest above it. Series: its table is "
                     "the height above it.")
                  .once("water.wave_height")
                  .setting_off(SetsOff::edge_clock)
                  .following_tables(Driven::within_tick),
              &WaterSettings::wave_height_m),
        bound(number("water.wave_period_s", preset.wave_period_s, 1e-3, 1e6, "s", "Period of the sine.")
                  .once("water.wave_period")
                  .setting_off(SetsOff::edge_clock),
              &WaterSettings::wave_period_s),
        bound(number("water.wave_depth_m", preset.wave_depth_m, 1e-3, 1e5, "m",
                     "Still depth that gives the solitary wave its length and speed.")
                  .once("water.wave_depth")
                  .setting_off(SetsOff::edge_clock),
              &WaterSettings::wave_depth_m)};
    return table;
}

WaterSettings water_settings_of(const Parameters& parameters) {
    WaterSettings settings = bound_settings(water_parameters(), parameters);
    // Either of two opposite edges joins them.
    for (const std::size_t edge : {0U, 2U})
        if (settings.edges[edge] == EdgeKind::periodic || settings.edges[edge + 1] == EdgeKind::periodic)
            settings.edges[edge] = settings.edges[edge + 1] = EdgeKind::periodic;
    settings.has_sea = parameters.is_given("water.sea_level_m");
    settings.sediment = sediment_settings(parameters);
    settings.counts_maps = counts_maps(parameters);
    return settings;
}

const std::vector<WaterDrive>& water_drives() {
    static const std::vector<WaterDrive> all = {{"water.rain_mm_per_h", &WaterDrives::rain_mm_per_h},
                                                {"water.inflow_m3_per_s", &WaterDrives::inflow_m3_per_s},
                                                {"water.sea_level_m", &WaterDrives::sea_level_m},
                                                {"water.wave_height_m", &WaterDrives::wave_height_m}};
    return all;
}

const std::vector<std::string>& edge_kinds() {
    static const std::vector<std::string> kinds = {"wall", "open", "level", "inflow", "wave", "periodic"};
    return kinds;
}

double shallow_speed_excess(double depth_m, double period_s, double gravity_m_per_s2) {
    const double omega = 2 * std::numbers::pi / period_s;
    const double target = omega * omega * depth_m / gravity_m_per_s2;
    // kd tanh kd = target: the left side rises with kd and lies between min(kd, kd²) / 2 and kd².
    double low = std::sqrt(target);
    double high = low + target + 1;
    for (int i = 0; i < 100; ++i) {
        const double middle = (low + high) / 2;
        (middle * std::tanh(middle) < target ? low : high) = middle;
    }
    const double kd = (low + high) / 2;
    return std::sqrt(kd / std::tanh(kd)) - 1;
}

}  // namespace talus
