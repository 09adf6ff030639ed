#include "app/core/sections.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "sim/error.h"

namespace talus::app {

void Sections::tell(Simulation& simulation) const {
    std::vector<Section> lines;
    lines.reserve(sections_.size());
    for (const PlacedSection& one : sections_) lines.push_back(one.section);
    simulation.follow_sections(lines);
}

Sections::Sections(Simulation& simulation, std::vector<PlacedSection> sections, std::vector<double> times_s)
    : sections_(std::move(sections)), times_s_(std::move(times_s)) {
    for (PlacedSection& one : sections_) {
        if (one.first_row + one.volumes_m3.size() != times_s_.size())
            throw Error(fmt::format("a section has {} rows from row {} on, of a table of {}",
                                    one.volumes_m3.size(), one.first_row, times_s_.size()));
        one.kept_m3 = one.volumes_m3.empty() ? 0 : one.volumes_m3.back();
    }
    tell(simulation);
    if (!times_s_.empty()) asked_s_ = times_s_.back();
}

void Sections::place(Simulation& simulation, const Section& section, glm::dvec2 heights_m) {
    // A row of this very time holds it too.
    const bool is_now = !times_s_.empty() && times_s_.back() == simulation.clock().simulated_s;
    sections_.push_back({section, heights_m, times_s_.size(), {}});
    if (is_now) {
        sections_.back().first_row -= 1;
        sections_.back().volumes_m3 = {0};
    }
    try {
        tell(simulation);
    } catch (...) {
        sections_.pop_back();
        throw;
    }
    // What was asked for is asked for again.
    asking_ = false;
    asked_s_ = times_s_.empty() ? -1 : times_s_.back();
}

void Sections::remove(Simulation& simulation, std::size_t index) {
    if (index >= sections_.size()) return;
    sections_.erase(sections_.begin() + static_cast<std::ptrdiff_t>(index));
    tell(simulation);
    asking_ = false;
    if (sections_.empty()) times_s_.clear();
    asked_s_ = times_s_.empty() ? -1 : times_s_.back();
}

void Sections::go_back_to(double time_s) {
    if (time_s >= asked_s_ && (times_s_.empty() || times_s_.back() <= time_s)) return;
    const auto kept = static_cast<std::size_t>(std::upper_bound(times_s_.begin(), times_s_.end(), time_s) -
                                               times_s_.begin());
    times_s_.resize(kept);
    for (PlacedSection& one : sections_) {
        one.first_row = std::min(one.first_row, kept);
        one.volumes_m3.resize(kept - one.first_row);
    }
    asking_ = false;
    asked_s_ = times_s_.empty() ? -1 : times_s_.back();
}

void Sections::append(double time_s, const std::vector<double>& volumes_m3) {
    times_s_.push_back(time_s);
    // Another terrain has no sections.
    for (std::size_t i = 0; i < sections_.size(); ++i)
        sections_[i].volumes_m3.push_back(sections_[i].kept_m3 + (i < volumes_m3.size() ? volumes_m3[i] : 0));
}

void Sections::record(const Simulation& simulation) {
    go_back_to(simulation.clock().simulated_s);
    if (!times_s_.empty() && times_s_.back() == simulation.clock().simulated_s) return;
    append(simulation.clock().simulated_s, simulation.section_volumes_m3());
    // A row that was asked for before is none any more.
    asking_ = false;
    asked_s_ = simulation.clock().simulated_s;
}

void Sections::follow(Simulation& simulation) {
    if (sections_.empty()) return;
    const double time_s = simulation.clock().simulated_s;
    go_back_to(time_s);
    if (asking_) {
        const auto volumes_m3 = simulation.poll_section_volumes();
        if (!volumes_m3) return;
        append(asked_s_, *volumes_m3);
        asking_ = false;
    }
    if (time_s == asked_s_) return;
    asked_s_ = time_s;
    asking_ = true;
    simulation.ask_section_volumes();
}

double Sections::discharge_m3_per_s(const PlacedSection& section, std::size_t row) const {
    if (row <= section.first_row) return 0;
    const std::size_t at = row - section.first_row;
    const double passed_s = times_s_[row] - times_s_[row - 1];
    return passed_s > 0 ? (section.volumes_m3[at] - section.volumes_m3[at - 1]) / passed_s : 0;
}

std::string Sections::to_csv() const {
    std::string csv = "time_s";
    for (std::size_t i = 1; i <= sections_.size(); ++i)
        csv += fmt::format(",discharge_{0}_m3_per_s,volume_{0}_m3", i);
    csv += "\n";
    for (std::size_t row = 0; row < times_s_.size(); ++row) {
        csv += fmt::format("{}", times_s_[row]);
        for (const PlacedSection& one : sections_) {
            const bool is_there = row >= one.first_row;
            csv += row > one.first_row ? fmt::format(",{}", discharge_m3_per_s(one, row)) : ",";
            csv += is_there ? fmt::format(",{}", one.volumes_m3[row - one.first_row]) : ",";
        }
        csv += "\n";
    }
    return csv;
}

}  // namespace talus::app
