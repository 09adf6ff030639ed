#pragma once
#include <vector>

#include "tests/bench/papers/terrains.h"

namespace talus::bench {

/// Mean squares of distances over many pictures, as decibels (Ammann 2010, section 4.1). R: the terrain's
/// diagonal. Pixels where one of both shows the sky have no distance: they are not counted.
class Psnr {
  public:
    explicit Psnr(const PaperTerrain& terrain);
    void add(const std::vector<float>& shown, const std::vector<float>& reference);
    void add(const std::vector<float>& shown, const std::vector<double>& reference);
    double db() const;

  private:
    double diagonal_m_;
    double sum_ = 0;
    double count_ = 0;
};

}  // namespace talus::bench
