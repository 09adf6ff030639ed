#pragma once
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "sim/simulation.h"

namespace talus::app {

/// A line over the map and the water that passed it since the section was placed.
struct PlacedSection {
    Section section;
    glm::dvec2 heights_m{0};         ///< of the ground at its ends, for the picture
    std::size_t first_row = 0;       ///< of the table
    std::vector<double> volumes_m3;  ///< a row each, to the right of its line as positive
    double kept_m3 = 0;              ///< of the last row that a project kept: the count goes on from it
};

/// What passed lines over the map against time: rows of one time each, with the volume of every section that
/// was there.
class Sections {
  public:
    Sections() = default;
    /// Those that were kept, with their table: the simulation counts what passes them from now on. Throws
    /// talus::Error where one lies off the map, or the table is none.
    Sections(Simulation& simulation, std::vector<PlacedSection> sections, std::vector<double> times_s);

    /// The simulation counts what passes it from now on. Throws talus::Error where it lies off the map.
    void place(Simulation& simulation, const Section& section, glm::dvec2 heights_m = glm::dvec2(0));
    void remove(Simulation& simulation, std::size_t index);
    const std::vector<PlacedSection>& all() const { return sections_; }
    const std::vector<double>& times_s() const { return times_s_; }

    /// Takes a row as it is now, where there is none yet. Waits for the device. Rows after a time that was
    /// gone back from are dropped.
    void record(const Simulation& simulation);
    /// The same without waiting, for a window's frames: asks for a row when the time has changed, and takes
    /// it when it has come. Rows after a time that was gone back from are dropped.
    void follow(Simulation& simulation);

    /// Of a row of the table, m³/s: the mean since the row above; 0 in a section's first one.
    double discharge_m3_per_s(const PlacedSection& section, std::size_t row) const;
    /// time_s and, for each section, discharge (m³/s, mean since the row above; empty in its first one) and
    /// volume (m³) so far; empty fields before it was placed.
    std::string to_csv() const;

  private:
    /// Undo does: later rows are none any more.
    void go_back_to(double time_s);
    void append(double time_s, const std::vector<double>& volumes_m3);
    void tell(Simulation& simulation) const;

    std::vector<PlacedSection> sections_;
    std::vector<double> times_s_;
    double asked_s_ = -1;
    bool asking_ = false;
};

}  // namespace talus::app
