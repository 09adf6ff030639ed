#pragma once
#include <functional>
#include <vector>

namespace talus {

/// What new samples are made of along one axis: for each the first old one and weights from there on, summing
/// to 1.
struct Taps {
    std::vector<int> first;
    std::vector<std::vector<double>> weights;
};

/// New sample i lies at place_of(i) among `count` old ones; the kernel is looked at up to `reach` beside it.
/// Old samples beyond the edge count as the edge.
Taps taps_of(int count, int new_count, const std::function<double(int)>& place_of, double reach,
             const std::function<double(double)>& kernel);

/// A plane of rows of nx samples, filtered along both axes.
std::vector<double> filtered(const std::vector<double>& plane, int nx, const Taps& columns, const Taps& rows);

}  // namespace talus
