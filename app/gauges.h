#pragma once
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "sim/terrain/terrain.h"

namespace talus {

/// Water at places on the map against time, as a table for people and programs: a row a tick with the time
/// and, for each gauge, level (m), depth (m) and speed (m/s).
class Gauges {
  public:
    /// Throws talus::Error when a place (m) lies off the map.
    Gauges(const Grid& grid, std::vector<glm::dvec2> places_m);

    bool empty() const { return places_m_.empty(); }
    /// Takes a row. Waits for the device.
    void record(const Terrain& terrain, double time_s);
    std::string to_csv() const { return csv_; }

  private:
    std::vector<glm::dvec2> places_m_;
    std::string csv_;
};

}  // namespace talus
