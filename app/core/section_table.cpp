#include "app/core/section_table.h"

#include <fmt/format.h>

namespace talus::app {

SectionTable::SectionTable(Simulation& simulation, const std::vector<Section>& sections)
    : count_(sections.size()) {
    simulation.follow_sections(sections);
    record(simulation);
}

void SectionTable::record(const Simulation& simulation) {
    rows_.push_back({simulation.clock().simulated_s, simulation.section_volumes_m3()});
    // Another terrain has no sections.
    rows_.back().volumes_m3.resize(count_, 0);
}

std::string SectionTable::to_csv() const {
    std::string csv = "time_s";
    for (std::size_t i = 1; i <= count_; ++i) csv += fmt::format(",discharge_{0}_m3_per_s,volume_{0}_m3", i);
    csv += "\n";
    for (std::size_t row = 0; row < rows_.size(); ++row) {
        csv += fmt::format("{}", rows_[row].time_s);
        for (std::size_t i = 0; i < count_; ++i) {
            const double volume_m3 = rows_[row].volumes_m3[i];
            if (row == 0) {
                csv += fmt::format(",,{}", volume_m3);
                continue;
            }
            const Row& before = rows_[row - 1];
            csv += fmt::format(",{},{}",
                               (volume_m3 - before.volumes_m3[i]) / (rows_[row].time_s - before.time_s),
                               volume_m3);
        }
        csv += "\n";
    }
    return csv;
}

}  // namespace talus::app
