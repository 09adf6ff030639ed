#pragma once
#include <memory>
#include <vector>

namespace talus {

/// Values against simulated time, linear between their rows. Before the first row it has the first value,
/// behind the last row the last one. Two rows of one time are a jump: from that time on the later one holds.
/// Copies share their rows.
class TimeSeries {
  public:
    struct Row {
        double time_s = 0;
        double value = 0;
        bool operator==(const Row&) const = default;
    };

    /// No rows: its values are 0.
    TimeSeries() = default;
    /// Throws talus::Error where there is no row, a number is not finite or above 1e15, or a time comes
    /// before that of the row above it.
    explicit TimeSeries(std::vector<Row> rows);

    bool empty() const { return table_ == nullptr; }
    const std::vector<Row>& rows() const;

    double at(double time_s) const;
    /// Its integral over time, in units of the value times a second: exact but for rounding, however many
    /// rows lie between.
    double integral(double from_s, double to_s) const;
    /// Its mean over a span of time; where the span is empty, its value there.
    double mean(double from_s, double to_s) const;
    /// The same this much later.
    TimeSeries later_by(double span_s) const;
    double lowest() const;
    double highest() const;

    bool operator==(const TimeSeries& other) const {
        return table_ == other.table_ || rows() == other.rows();
    }

  private:
    double integral_to(double time_s) const;

    struct Table {
        std::vector<Row> rows;
        std::vector<double> integrals;  ///< from the first row to each row
        double lowest = 0;
        double highest = 0;
    };
    std::shared_ptr<const Table> table_;
};

}  // namespace talus
