#include "sim/drives.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
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
    return std::holds_alternative<double>(p.preset) && p.driven != Driven::never;
}

void check_drive(const Parameters& parameters, const Drive& drive) {
    const Parameter& p = parameters.declaration(drive.parameter);
    if (!std::holds_alternative<double>(p.preset))
        throw Error(fmt::format("{} is not a number and cannot follow a table", p.name));
    if (!can_be_driven(p))
        throw Error(fmt::format("{} cannot change from tick to tick, so it cannot follow a table", p.name));
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
    std::vector<double> numbers;
    for (std::string word; words >> word;) {
        double number = 0;
        const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
        if (error != std::errc() || end != word.data() + word.size())
            throw Error(fmt::format("row {} of a table is not a time and a value", numbers.size() / 2 + 1));
        numbers.push_back(number);
    }
    if (numbers.size() % 2 != 0)
        throw Error(fmt::format("row {} of a table has a time and no value", numbers.size() / 2 + 1));
    std::vector<TimeSeries::Row> rows;
    rows.reserve(numbers.size() / 2);
    for (std::size_t i = 0; i < numbers.size(); i += 2) rows.push_back({numbers[i], numbers[i + 1]});
    return TimeSeries(std::move(rows));
}

}  // namespace talus
