#include "sim/simulation_parameters.h"

#include "sim/passes/water.h"
#include "sim/terrain/generate.h"
#include "sim/terrain/grid.h"

namespace talus {

std::vector<Parameter> simulation_parameters() {
    return {
        choice("terrain.kind", "mountains", generator_kinds(),
               "Shape of the generated terrain, where no file is opened."),
        whole("terrain.nx", 513, min_samples, max_samples, "samples", "Columns of the generated terrain."),
        whole("terrain.ny", 513, min_samples, max_samples, "samples", "Rows of the generated terrain."),
        number("terrain.spacing_m", 20, 1e-3, 1e5, "m", "Distance between samples of the generated terrain."),
        number("terrain.relief_m", 1800, 0, 1e5, "m",
               "Height of the generated terrain from lowest to highest."),
        whole("terrain.seed", 1, 0, 1000000, "", "Another seed gives another generated terrain."),
        choice("terrain.water", "none", starting_waters(),
               "Water that the generated terrain starts with: none; dam, behind a dam a third of the way "
               "east that "
               "has just gone; bowl, Thacker's round wave; wave, a sea with a single wave on its way "
               "eastwards; cloudburst, a quarter of a metre everywhere."),
        number("time.tick_s", 1.0 / 60, 1e-6, 1e9, "s", "Simulated time of one tick."),
        toggle("thermal.on", true, "Thermal erosion: what is steeper than its angle of repose slides."),
        number("thermal.repose_deg", 33, 1, 80, "°",
               "Angle of repose: the steepest slope at which loose ground rests."),
        number("thermal.rate_m2_per_s", 0, 0, 1e12, "m²/s",
               "How fast steep ground slides. Unless set, it follows the spacing: one sub-step a tick."),
        number("thermal.bedrock_deg", 33, 1, 89, "°",
               "Angle that bedrock fails at. Unless set, it slides at the angle of repose, like scree."),
        number("thermal.wet_deg", 33, 1, 80, "°",
               "Angle of repose of regolith under water. Unless set, the same as in the dry."),
        number("thermal.weathering", 0, 0, 1e6, "mm/h",
               "How fast bare bedrock turns into regolith; half a metre of regolith halves it."),
        toggle(
            "erosion.on", false,
            "Running water takes solid from its bed, carries it, and lets it settle where it slackens. Off: "
            "what is on its way still settles."),
        choice("erosion.over", "everywhere", {"everywhere", "mask"},
               "Where water takes solid and slopes slide; by the mask: as far as it says, so that a brush "
               "erodes here and nowhere else."),
        number(
            "erosion.erodibility", 1, 0, 1e6, "cm³/(N s)",
            "Of regolith: a pascal above the critical stress takes so many millionths of a metre a second. "
            "0.01 stiff clay, 1 to 100 loose ground (Hanson & Simon 2001)."),
        number("erosion.bedrock_erodibility", 0.1, 0, 1e6, "cm³/(N s)", "Of bedrock."),
        number(
            "erosion.critical_shear", 5, 0, 1e6, "Pa",
            "Shear stress of the water on its bed that takes nothing yet. The stress follows water.manning: "
            "where that is 0, nothing erodes."),
        number("erosion.settling", 10, 0, 1e4, "mm/s",
               "How fast grains settle in still water: 0.01 silt, 10 fine sand, 100 gravel."),
        number("erosion.porosity", 0, 0, 0.9, "",
               "Share of voids in regolith: in what settles and in scree. 0.3 to 0.4 in sand."),
        number("erosion.acceleration", 1, 1, 1000, "",
               "How often each exchange counts for the ground: geology waits for no water (morphological "
               "factor)."),
        number("erosion.inflow_concentration", 0, 0, 0.3, "",
               "Solid in the water that enters by edges of kind inflow, by volume."),
        number("erosion.strata_m", 0, 0, 1e5, "m",
               "Bedrock in level layers: thickness of a hard and a soft one together; 0: none."),
        number("erosion.strata_hardness", 0.9, 0, 1, "", "Hardness of the hard ones; 1 does not erode."),
        toggle("water.on", true, "Water flows. Where there is none, and none comes, it costs nothing."),
        whole("water.order", 2, 1, 2, "", "Order of the scheme: 1 is cheaper, 2 far more exact."),
        number("water.gravity", 9.81, 0.01, 100, "m/s²", "Acceleration of gravity."),
        number("water.manning", 0.03, 0, 1, "s/m^(1/3)",
               "Manning's roughness of the bed: 0 none, 0.03 a natural stream, 0.1 a wooded flood plain."),
        number("water.rain", 0, 0, 1e4, "mm/h",
               "Rain: everywhere, or by the mask; what a brush of rain painted falls besides."),
        choice("water.rain_over", "everywhere", {"everywhere", "mask"},
               "Where water.rain falls; by the mask: as much of it as the mask says."),
        number("water.infiltration", 0, 0, 1e4, "mm/h",
               "Water that the ground takes in, where there is any."),
        number("water.evaporation", 0, 0, 1e4, "mm/h", "Water that the air takes, where there is any."),
        number("water.sea_level", 0, -1e6, 1e6, "m",
               "Level of the sea. When set, it fills what lies lower and is connected to the map's edge; "
               "edges of "
               "kind level hold it, and it is the still level of edges of kind wave."),
        choice(
            "water.boundary.north", "open", edge_kinds(),
            "Northern edge: a wall, open (waves leave), a held level, an inflow, a wave maker, or periodic "
            "(joined to the opposite edge, whatever that is set to)."),
        choice("water.boundary.south", "open", edge_kinds(), "Southern edge, as the northern one."),
        choice("water.boundary.west", "open", edge_kinds(), "Western edge, as the northern one."),
        choice("water.boundary.east", "open", edge_kinds(), "Eastern edge, as the northern one."),
        number("water.inflow", 0, 0, 1e9, "m³/s",
               "Discharge through all edges of kind inflow together, at its peak; spread evenly along them."),
        number("water.inflow_rise", 0, 0, 1e9, "s", "Time that the inflow takes from nothing to its peak."),
        number("water.inflow_fall", 0, 0, 1e9, "s",
               "Time that it takes from the peak back to nothing; 0: it stays at its peak."),
        choice("water.wave", "sine", {"sine", "solitary"}, "What the wave maker sends."),
        number("water.wave_height", 1, 0, 1e4, "m",
               "Sine: amplitude about the still level. Solitary: crest above it."),
        number("water.wave_period", 10, 1e-3, 1e6, "s", "Period of the sine."),
        number("water.wave_depth", 10, 1e-3, 1e5, "m",
               "Still depth that gives the solitary wave its length and speed."),
    };
}

}  // namespace talus
