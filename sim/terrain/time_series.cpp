#include "sim/terrain/time_series.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "sim/error.h"

namespace talus {
namespace {

constexpr double largest_number = 1e15;

// The first row behind a time.
std::size_t row_behind(const std::vector<TimeSeries::Row>& rows, double time_s) {
    const auto behind =
        std::upper_bound(rows.begin(), rows.end(), time_s,
                         [](double time, const TimeSeries::Row& row) { return time < row.time_s; });
    return static_cast<std::size_t>(behind - rows.begin());
}

}  // namespace

TimeSeries::TimeSeries(std::vector<Row> rows) {
    if (rows.empty()) throw Error("a table against time needs at least one row");
    std::vector<double> integrals = {0};
    integrals.reserve(rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
        // Not `>`: what is no number fails too.
        if (!(std::abs(rows[i].time_s) <= largest_number && std::abs(rows[i].value) <= largest_number))
            throw Error(
                fmt::format("row {} of a table against time must hold finite numbers up to 1e15", i + 1));
        if (i == 0) continue;
        const double span_s = rows[i].time_s - rows[i - 1].time_s;
        if (span_s < 0)
            throw Error(fmt::format("{} s comes after {} s in a table against time, times must not fall",
                                    rows[i].time_s, rows[i - 1].time_s));
        integrals.push_back(integrals.back() + 0.5 * span_s * (rows[i].value + rows[i - 1].value));
    }
    const auto [low, high] = std::minmax_element(
        rows.begin(), rows.end(), [](const Row& a, const Row& b) { return a.value < b.value; });
    const double lowest = low->value;
    const double highest = high->value;
    table_ = std::make_shared<const Table>(Table{std::move(rows), std::move(integrals), lowest, highest});
}

const std::vector<TimeSeries::Row>& TimeSeries::rows() const {
    static const std::vector<Row> none;
    return table_ ? table_->rows : none;
}

double TimeSeries::at(double time_s) const {
    const std::vector<Row>& all = rows();
    if (all.empty()) return 0;
    const std::size_t behind = row_behind(all, time_s);
    if (behind == 0) return all.front().value;
    if (behind == all.size()) return all.back().value;
    const Row& a = all[behind - 1];
    const Row& b = all[behind];
    return a.value + (time_s - a.time_s) / (b.time_s - a.time_s) * (b.value - a.value);
}

// From the first row's time to one that is not before it.
double TimeSeries::integral_to(double time_s) const {
    const std::vector<Row>& all = rows();
    const std::size_t last = row_behind(all, time_s) - 1;
    return table_->integrals[last] + 0.5 * (time_s - all[last].time_s) * (at(time_s) + all[last].value);
}

double TimeSeries::integral(double from_s, double to_s) const {
    const std::vector<Row>& all = rows();
    if (all.empty()) return 0;
    // Within one stretch without the table's sums: the difference of two long ones is less exact.
    if (row_behind(all, from_s) == row_behind(all, to_s))
        return 0.5 * (to_s - from_s) * (at(from_s) + at(to_s));
    const double first_s = all.front().time_s;
    const double before = std::min(from_s, first_s) - std::min(to_s, first_s);
    return integral_to(std::max(to_s, first_s)) - integral_to(std::max(from_s, first_s)) -
           before * all.front().value;
}

double TimeSeries::mean(double from_s, double to_s) const {
    // Rounding must not take it out of what its parameter allows.
    return to_s > from_s ? std::clamp(integral(from_s, to_s) / (to_s - from_s), lowest(), highest())
                         : at(from_s);
}

TimeSeries TimeSeries::later_by(double span_s) const {
    if (empty()) return {};
    std::vector<Row> moved = rows();
    for (Row& row : moved) row.time_s += span_s;
    return TimeSeries(std::move(moved));
}

double TimeSeries::lowest() const {
    return table_ ? table_->lowest : 0;
}

double TimeSeries::highest() const {
    return table_ ? table_->highest : 0;
}

}  // namespace talus
