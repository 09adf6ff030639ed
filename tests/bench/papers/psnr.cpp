#include "tests/bench/papers/psnr.h"

#include <algorithm>
#include <cmath>

namespace talus::bench {
namespace {

template <typename Real>
void add_squares(const std::vector<float>& shown, const std::vector<Real>& reference, double& sum,
                 double& count) {
    for (std::size_t i = 0; i < shown.size(); ++i) {
        if (std::isinf(reference[i]) || std::isinf(shown[i])) continue;
        sum += (shown[i] - reference[i]) * (shown[i] - reference[i]);
        ++count;
    }
}

}  // namespace

Psnr::Psnr(const PaperTerrain& terrain) {
    const auto [low, high] = std::minmax_element(terrain.heights.begin(), terrain.heights.end());
    diagonal_m_ = std::hypot(terrain.grid.width_m(), terrain.grid.height_m(), *high - *low);
}

void Psnr::add(const std::vector<float>& shown, const std::vector<float>& reference) {
    add_squares(shown, reference, sum_, count_);
}

void Psnr::add(const std::vector<float>& shown, const std::vector<double>& reference) {
    add_squares(shown, reference, sum_, count_);
}

double Psnr::db() const {
    return sum_ > 0 ? 10 * std::log10(diagonal_m_ * diagonal_m_ * count_ / sum_) : 999;
}

}  // namespace talus::bench
