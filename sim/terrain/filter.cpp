#include "sim/terrain/filter.h"

#include <algorithm>
#include <cmath>

namespace talus {

Taps taps_of(int count, int new_count, const std::function<double(int)>& place_of, double reach,
             const std::function<double(double)>& kernel) {
    Taps taps;
    for (int i = 0; i < new_count; ++i) {
        const double place = place_of(i);
        const int low = static_cast<int>(std::ceil(place - reach));
        const int high = static_cast<int>(std::floor(place + reach));
        const int first = std::clamp(low, 0, count - 1);
        const int last = std::clamp(high, 0, count - 1);
        std::vector<double> weights(static_cast<std::size_t>(last - first + 1), 0.0);
        double sum = 0;
        for (int j = low; j <= high; ++j) {
            const double weight = kernel(j - place);
            weights[static_cast<std::size_t>(std::clamp(j, first, last) - first)] += weight;
            sum += weight;
        }
        for (double& weight : weights) weight /= sum;
        taps.first.push_back(first);
        taps.weights.push_back(std::move(weights));
    }
    return taps;
}

std::vector<double> filtered(const std::vector<double>& plane, int nx, const Taps& columns,
                             const Taps& rows) {
    const auto new_nx = columns.first.size();
    const auto new_ny = rows.first.size();
    const std::size_t ny = plane.size() / static_cast<std::size_t>(nx);
    std::vector<double> wide(new_nx * ny);
    for (std::size_t y = 0; y < ny; ++y)
        for (std::size_t x = 0; x < new_nx; ++x) {
            const double* from = &plane[y * static_cast<std::size_t>(nx) + columns.first[x]];
            double sum = 0;
            for (const double weight : columns.weights[x]) sum += weight * *from++;
            wide[y * new_nx + x] = sum;
        }
    std::vector<double> result(new_nx * new_ny, 0.0);
    for (std::size_t y = 0; y < new_ny; ++y)
        for (std::size_t tap = 0; tap < rows.weights[y].size(); ++tap) {
            const double weight = rows.weights[y][tap];
            const double* from = &wide[(static_cast<std::size_t>(rows.first[y]) + tap) * new_nx];
            for (std::size_t x = 0; x < new_nx; ++x) result[y * new_nx + x] += weight * from[x];
        }
    return result;
}

}  // namespace talus
