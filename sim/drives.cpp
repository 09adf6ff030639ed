#include "sim/drives.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <sstream>

#include "sim/error.h"

namespace talus {

const TimeSeries* series_of(const std::vector<Drive>& drives, std::string_view parameter) {
    const auto found = std::find_if(drives.begin(), drives.end(),
                                    [&](const Drive& drive) { return drive.parameter == parameter; });
    return found == drives.end() ? nullptr : &found->series;
}

void place_drive(std::vector<Drive>& drives, const Drive& drive) {
    const auto same = std::find_if(drives.begin(), drives.end(),
                                   [&](const Drive& one) { return one.parameter == drive.parameter; });
    if (drive.series.empty()) {
        if (same != drives.end()) drives.erase(same);
    } else if (same != drives.end()) {
        *same = drive;
    } else {
        drives.push_back(drive);
    }
}

bool can_be_driven(const Parameter& p) {
    const bool holds_for_a_run = p.name.starts_with("terrain.") || p.name == "time.tick_s";
    return std::holds_alternative<double>(p.preset) && !holds_for_a_run &&
           p.sets_off != SetsOff::solid_weights;
}

void check_drive(const Parameters& parameters, const Drive& drive) {
    const Parameter& p = parameters.declaration(drive.parameter);
    if (!std::holds_alternative<double>(p.preset))
        throw Error(fmt::format("{} is not a number and cannot follow a table", p.name));
    if (!can_be_driven(p))
        throw Error(fmt::format("{} holds for a whole run and cannot follow a table", p.name));
    for (const TimeSeries::Row& row : drive.series.rows())
        if (row.value < p.low || row.value > p.high)
            throw Error(fmt::format("{} cannot follow a table with {} at {} s, it must be {} to {}{}{}",
                                    p.name, row.value, row.time_s, p.low, p.high, p.unit.empty() ? "" : " ",
                                    p.unit));
}

std::string to_text(const TimeSeries& series) {
    std::string text;
    for (const TimeSeries::Row& row : series.rows())
        fmt::format_to(std::back_inserter(text), "{}{} {}", text.empty() ? "" : " ", row.time_s, row.value);
    return text;
}

TimeSeries series_from_text(const std::string& text) {
    std::istringstream words(text);
    std::vector<TimeSeries::Row> rows;
    for (TimeSeries::Row row; words >> row.time_s >> row.value;) rows.push_back(row);
    if (!words.eof()) throw Error(fmt::format("'{}' is not times and values", text));
    return TimeSeries(std::move(rows));
}

}  // namespace talus
