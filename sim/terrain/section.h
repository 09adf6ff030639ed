#pragma once
#include <glm/glm.hpp>
#include <vector>

#include "sim/terrain/grid.h"

namespace talus {

/// A line over the map, metres from the south-west sample, through which water is measured. What passes to
/// the right of one who looks from its first end to its second counts as positive.
struct Section {
    glm::dvec2 from_m{0};
    glm::dvec2 to_m{0};
    bool operator==(const Section&) const = default;
};

/// A face between two samples.
struct SectionFace {
    glm::ivec2 at{
        0};  ///< the sample east of it, or north of it: column and row, one beyond the map at its far edges
    bool is_row = false;  ///< between rows: its discharge counts northwards; else between columns, eastwards
    int sign = 1;         ///< of the discharge that counts as positive
    bool operator==(const SectionFace&) const = default;
};

/// Throws talus::Error where an end lies off the map, or both ends are nearest to one corner of the samples'
/// cells, so that no face lies between.
void check_section(const Grid& grid, const Section& section);

/// The staircase of faces along the line, from the corner of the samples' cells that is nearest to its first
/// end to that of its second, with the fewest faces; each next corner is the one nearer to the line between
/// both. An end on the outermost samples lies at the map's edge, so a line from edge to edge cuts the map in
/// two, and a line along an edge is that edge.
std::vector<SectionFace> faces_of(const Grid& grid, const Section& section);

}  // namespace talus
