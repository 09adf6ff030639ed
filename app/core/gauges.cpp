#include "app/core/gauges.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "sim/error.h"

namespace talus::app {

Gauges::Gauges(const Grid& grid, std::vector<Gauge> gauges, std::vector<double> times_s)
    : grid_(grid), gauges_(std::move(gauges)), times_s_(std::move(times_s)) {
    for (const Gauge& gauge : gauges_) {
        check(gauge.place_m);
        if (gauge.first_row + gauge.readings.size() != times_s_.size())
            throw Error(fmt::format("a gauge has {} rows from row {} on, of a table of {}",
                                    gauge.readings.size(), gauge.first_row, times_s_.size()));
    }
    if (!times_s_.empty()) asked_s_ = times_s_.back();
}

void Gauges::check(glm::dvec2 place_m) const {
    if (!(place_m.x >= 0 && place_m.x <= grid_.width_m() && place_m.y >= 0 && place_m.y <= grid_.height_m()))
        throw Error(fmt::format("gauge at {},{} m lies off the map, it must lie within 0,0 and {},{} m",
                                place_m.x, place_m.y, grid_.width_m(), grid_.height_m()));
}

void Gauges::place(glm::dvec2 place_m) {
    check(place_m);
    gauges_.push_back({place_m, times_s_.size(), {}});
    asking_ = false;
    asked_s_ = -1;
}

void Gauges::remove(std::size_t index) {
    if (index >= gauges_.size()) return;
    gauges_.erase(gauges_.begin() + static_cast<std::ptrdiff_t>(index));
    asking_ = false;
    if (gauges_.empty()) times_s_.clear();
}

void Gauges::move(std::size_t index, glm::dvec2 place_m) {
    check(place_m);
    if (index >= gauges_.size() || gauges_[index].place_m == place_m) return;
    gauges_[index] = {place_m, times_s_.size(), {}};
    asking_ = false;
    asked_s_ = -1;
}

void Gauges::go_back_to(double time_s) {
    if (time_s >= asked_s_ && (times_s_.empty() || times_s_.back() <= time_s)) return;
    const auto kept = static_cast<std::size_t>(std::upper_bound(times_s_.begin(), times_s_.end(), time_s) -
                                               times_s_.begin());
    times_s_.resize(kept);
    for (Gauge& gauge : gauges_) {
        gauge.first_row = std::min(gauge.first_row, kept);
        gauge.readings.resize(kept - gauge.first_row);
    }
    // What was asked for then is no row of this time.
    asking_ = false;
    asked_s_ = times_s_.empty() ? -1 : times_s_.back();
}

void Gauges::append(double time_s, const std::vector<GaugeReading>& readings) {
    // A gauge that came since the last row, at the same time, completes that.
    if (times_s_.empty() || times_s_.back() != time_s) times_s_.push_back(time_s);
    for (std::size_t i = 0; i < gauges_.size(); ++i) {
        Gauge& gauge = gauges_[i];
        if (gauge.readings.empty()) gauge.first_row = times_s_.size() - 1;
        if (gauge.first_row + gauge.readings.size() < times_s_.size()) gauge.readings.push_back(readings[i]);
    }
}

void Gauges::record(const Terrain& terrain, double time_s) {
    go_back_to(time_s);
    const bool has_new = std::any_of(gauges_.begin(), gauges_.end(),
                                     [](const Gauge& gauge) { return gauge.readings.empty(); });
    if (!times_s_.empty() && times_s_.back() == time_s && !has_new) return;
    std::vector<GaugeReading> readings;
    readings.reserve(gauges_.size());
    for (const Gauge& gauge : gauges_)
        readings.push_back(read_gauge(terrain, gauge.place_m.x, gauge.place_m.y));
    append(time_s, readings);
    // A row that was asked for before is none any more.
    asking_ = false;
    asked_s_ = time_s;
}

void Gauges::follow(const Terrain& terrain, double time_s) {
    if (gauges_.empty()) return;
    go_back_to(time_s);
    if (asking_) {
        bool whole = true;
        for (std::size_t i = 0; i < gauges_.size(); ++i) {
            if (const auto ground = ground_[i]->poll()) coming_[i].ground_m = ground->front();
            if (const auto water = water_[i]->poll())
                set_water(coming_[i], {(*water)[0], (*water)[1], (*water)[2], (*water)[3]});
            whole = whole && !ground_[i]->pending() && !water_[i]->pending();
        }
        if (!whole) return;
        append(asked_s_, coming_);
        asking_ = false;
    }
    if (time_s == asked_s_) return;
    asked_s_ = time_s;
    asking_ = true;
    coming_.assign(gauges_.size(), GaugeReading());
    water_.clear();
    ground_.clear();
    for (const Gauge& gauge : gauges_) {
        const gpu::Region sample = gauge_sample(grid_, gauge.place_m.x, gauge.place_m.y);
        ground_.push_back(std::make_unique<gpu::Readback>());
        ground_.back()->start(terrain.ground, sample);
        water_.push_back(std::make_unique<gpu::Readback>());
        if (terrain.water) water_.back()->start(terrain.water->front, terrain.water->texels(sample));
    }
}

std::string Gauges::to_csv() const {
    std::string csv = "time_s";
    for (std::size_t i = 1; i <= gauges_.size(); ++i)
        csv += fmt::format(",level_{0}_m,depth_{0}_m,speed_{0}_m_per_s", i);
    csv += "\n";
    for (std::size_t row = 0; row < times_s_.size(); ++row) {
        csv += fmt::format("{}", times_s_[row]);
        for (const Gauge& gauge : gauges_) {
            if (row < gauge.first_row) {
                csv += ",,,";
                continue;
            }
            const GaugeReading& reading = gauge.readings[row - gauge.first_row];
            csv += fmt::format(",{},{},{}", reading.level_m(), reading.depth_m,
                               glm::length(reading.velocity_m_per_s));
        }
        csv += "\n";
    }
    return csv;
}

}  // namespace talus::app
