#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "sim/terrain/georeference.h"
#include "sim/terrain/grid.h"
#include "sim/terrain/time_series.h"

namespace talus {

/// Simulated time since the start.
struct Clock {
    std::int64_t ticks = 0;
    double simulated_s = 0;
    bool operator==(const Clock&) const = default;
};

/// Water that comes out of the ground at a place.
struct Spring {
    double x_m = 0;
    double y_m = 0;
    double rate_m3_per_s = 0;
    bool operator==(const Spring&) const = default;
};

/// A parameter that follows a table against simulated time (sim/drives.h).
struct Drive {
    std::string parameter;
    TimeSeries series;
    bool operator==(const Drive&) const = default;
};

/// A gap that opens in a dam along a line: its bottom sinks from the crest, evenly in time, and its width
/// grows with it. Sides stand at a slope.
struct Breach {
    glm::dvec2 from_m{0};
    glm::dvec2 to_m{0};
    double width_m = 10;    ///< of the bottom, at last
    double crest_m = 0;     ///< height that it begins at
    double bottom_m = 0;    ///< height that it ends at
    double side_slope = 1;  ///< rise over run
    double over_s = 0;      ///< time that it takes; 0: it is there at once
    bool operator==(const Breach&) const = default;
};

/// What happens at a simulated time (sim/events.h): a parameter takes a value, or a dam is breached.
struct Event {
    double at_s = 0;
    std::string assignment;  ///< "section.name=value"
    std::optional<Breach> breach = std::nullopt;
    bool done = false;
    bool operator==(const Event&) const = default;
};

/// Leaves out breaches of which an end lies off a map of this size. Roundings of an end on its edge are none.
void drop_breaches_beside(const Grid& grid, std::vector<Event>& events);
/// Whether a place (m) is on a map of this size, but for roundings.
bool is_on_map(const Grid& grid, glm::dvec2 place_m);

/// Everything that a run continues from, in main memory: rows of samples, row 0 north, heights in metres as
/// two words (high, low). What the document stores. `layers()` (sim/terrain/layers.h) describes its layers.
struct TerrainState {
    Grid grid;
    std::vector<glm::vec2> bedrock;
    std::vector<glm::vec2> regolith;
    /// Depth, m, two words, and discharge east and north, m²/s; empty: no water was ever here.
    std::vector<glm::vec4> water;
    /// Largest depth so far, m, and the simulated time at which water arrived, s; empty: none ever did.
    std::vector<glm::vec2> inundation;
    /// Solid in the water above a sample, m, two words; empty: none.
    std::vector<glm::vec2> suspended;
    /// What brushes painted: hardness and mask, 0 to 1, and rain, mm/h; empty: nothing.
    std::vector<glm::vec4> painted;
    /// What the water flows over where it is not as the parameters say: Manning's n, s/m^(1/3), times its
    /// share, that share, infiltration, mm/h, times its share, that share (shaders/maths/land_cover.glsl);
    /// empty: nowhere.
    std::vector<glm::vec4> land_cover;
    /// Water that left each sample over its faces, m³, two words; empty: none did.
    std::vector<glm::vec2> flow;
    /// Ground that was taken and laid down by water, by slopes and by hand, gross, m: wear and deposition,
    /// each of two words; empty: none was.
    std::vector<glm::vec4> worn_by_water;
    std::vector<glm::vec4> worn_by_slopes;
    std::vector<glm::vec4> worn_by_hand;
    /// The ground beyond the map's edges (sim/terrain/bed_beyond.h), m; empty: it is not known.
    std::vector<float> bed_beyond;
    /// The ground that a difference counts from, m, two words; empty: the ground as it is here. No part of
    /// the hash; of all that runs, only a mask that is made from the difference hangs on it.
    std::vector<glm::vec2> start;
    std::vector<Spring> springs;
    std::vector<Drive> drives;
    std::vector<Event> events;
    /// The simulated time from which inflow and wave maker count: when they were last set.
    double edges_since_s = 0;
    Clock clock;
    std::optional<Georeference> georeference;

    /// Ground = bedrock + regolith, rounded to one float a sample.
    std::vector<float> ground() const;
    /// The same in two words.
    std::vector<glm::vec2> ground_words() const;
};

/// A terrain of one layer of bedrock. Throws talus::Error when the grid cannot be used.
TerrainState bedrock_terrain(const Grid& grid, const std::vector<float>& heights_m);

/// An optional layer that is zero throughout is none.
void drop_zero_layers(TerrainState& state);

}  // namespace talus
