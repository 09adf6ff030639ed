#pragma once
#include <glm/glm.hpp>
#include <memory>
#include <string>
#include <vector>

#include "sim/gpu/readback.h"
#include "sim/terrain/gauge.h"
#include "sim/terrain/terrain.h"

namespace talus::app {

/// A place on the map and what its water did since the gauge was placed.
struct Gauge {
    glm::dvec2 place_m{0};
    std::size_t first_row = 0;  ///< of the table
    std::vector<GaugeReading> readings;
};

/// Water at places on the map against time: rows of one time each, with a reading of every gauge that was
/// there.
class Gauges {
  public:
    explicit Gauges(const Grid& grid) : grid_(grid) {}
    /// Those that were kept, with their table. Throws talus::Error where one lies off the map, or the table
    /// is none.
    Gauges(const Grid& grid, std::vector<Gauge> gauges, std::vector<double> times_s);

    /// Throws talus::Error when the place (m) lies off the map.
    void place(glm::dvec2 place_m);
    /// Where there is none of that number any more, these two do nothing.
    void remove(std::size_t index);
    /// It stands elsewhere from now on: its rows begin anew. Throws talus::Error when the place lies off the
    /// map.
    void move(std::size_t index, glm::dvec2 place_m);
    const std::vector<Gauge>& all() const { return gauges_; }
    /// True while a row is on its way.
    bool pending() const { return asking_; }
    const std::vector<double>& times_s() const { return times_s_; }

    /// Takes a row at this simulated time, where there is none yet. Waits for the device. Rows after a time
    /// that was gone back from are dropped.
    void record(const Terrain& terrain, double time_s);
    /// The same without waiting, for a window's frames: asks for a row when the time has changed, and takes
    /// it when it has come. Rows after a time that was gone back from are dropped.
    void follow(const Terrain& terrain, double time_s);

    /// time_s and, for each gauge, level (m), depth (m) and speed (m/s); empty fields before it was placed.
    std::string to_csv() const;

  private:
    void check(glm::dvec2 place_m) const;
    /// Undo does: later rows are none any more.
    void go_back_to(double time_s);
    void append(double time_s, const std::vector<GaugeReading>& readings);

    Grid grid_;
    std::vector<Gauge> gauges_;
    std::vector<double> times_s_;
    // A row on its way: the water and the ground of each gauge's sample.
    std::vector<std::unique_ptr<gpu::Readback>> water_;
    std::vector<std::unique_ptr<gpu::Readback>> ground_;
    std::vector<GaugeReading> coming_;
    double asked_s_ = -1;
    bool asking_ = false;
};

}  // namespace talus::app
