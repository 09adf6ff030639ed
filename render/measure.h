#pragma once
#include <vector>

#include "render/cast_twin.h"

namespace talus::render {

/// How far a picture is from the reference (law 1). A pixel's error is the smallest offset, in pixels, of a
/// reference ray that agrees with it: both hit or both miss, with distances equal to a relative 1e-4. If no
/// ray within the limit agrees, the error is the limit; `beyond` counts such pixels.
struct PictureError {
    int pixels_hit = 0;          ///< by the reference
    int wrong_coverage = 0;      ///< the ground where the reference has sky, or the reverse
    int silhouettes = 0;         ///< pixels on a crest: a neighbour is sky or more than 2 % farther
    int silhouettes_missed = 0;  ///< of those, pixels that show what lies behind the crest
    double psnr_db = 0;          ///< of the distance, Ammann 2010, section 4.1; R: the terrain's diagonal
    double mean_px = 0;
    double largest_px = 0;
    int beyond = 0;
};

/// Measures pictures of one terrain against the caster's double twin. Uses all cores.
class Measure {
  public:
    Measure(const Grid& grid, std::vector<float> ground);

    /// distances: a picture's distances along the pixels' rays (infinity: nothing hit), rows bottom up.
    /// limit_px: how far to look for a ray that agrees.
    PictureError compare(const Camera& camera, int width, int height, const std::vector<float>& distances,
                         double limit_px);

    /// The error of one pixel that shows this distance; more than the limit where no ray agrees.
    double error_px(const Camera& camera, int width, int height, int x, int y, double distance_m,
                    double limit_px);

    /// The reference's distances, rows bottom up, infinity where nothing is hit.
    std::vector<double> reference(const Camera& camera, int width, int height);

  private:
    Grid grid_;
    double diagonal_m_;
    maths::CastTwin<double> twin_;
};

}  // namespace talus::render
