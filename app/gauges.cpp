#include "app/gauges.h"

#include <fmt/format.h>

#include "sim/gpu/error.h"
#include "sim/terrain/gauge.h"

namespace talus {

Gauges::Gauges(const Grid& grid, std::vector<glm::dvec2> places_m)
    : places_m_(std::move(places_m)), csv_("time_s") {
    for (std::size_t i = 0; i < places_m_.size(); ++i) {
        const glm::dvec2 place = places_m_[i];
        if (!(place.x >= 0 && place.x <= grid.width_m() && place.y >= 0 && place.y <= grid.height_m()))
            throw Error(fmt::format("--gauge {},{} lies off the map, it must lie within 0,0 and {},{} m",
                                    place.x, place.y, grid.width_m(), grid.height_m()));
        csv_ += fmt::format(",level_{0}_m,depth_{0}_m,speed_{0}_m_per_s", i + 1);
    }
    csv_ += "\n";
}

void Gauges::record(const Terrain& terrain, double time_s) {
    csv_ += fmt::format("{}", time_s);
    for (const glm::dvec2 place : places_m_) {
        const GaugeReading reading = read_gauge(terrain, place.x, place.y);
        csv_ += fmt::format(",{},{},{}", reading.level_m(), reading.depth_m,
                            glm::length(reading.velocity_m_per_s));
    }
    csv_ += "\n";
}

}  // namespace talus
