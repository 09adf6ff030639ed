#pragma once
#include <string>
#include <vector>

#include "sim/simulation.h"

namespace talus::app {

/// What passed sections against simulated time, a row each time it is asked for.
class SectionTable {
  public:
    /// The simulation follows these sections from now on. Throws talus::Error where one lies off the map.
    SectionTable(Simulation& simulation, const std::vector<Section>& sections);

    /// Takes a row as it is now. Waits for the device.
    void record(const Simulation& simulation);

    /// time_s and, for each section, discharge (m³/s, mean since the row above; empty in the first one) and
    /// volume (m³) so far.
    std::string to_csv() const;

  private:
    struct Row {
        double time_s = 0;
        std::vector<double> volumes_m3;
    };
    std::vector<Row> rows_;
    std::size_t count_;
};

}  // namespace talus::app
