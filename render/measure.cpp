#include "render/measure.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <thread>

namespace talus::render {
namespace {

constexpr double agreement = 1e-4;

void over_rows(int rows, const std::function<void(int)>& work) {
    const int count = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
    std::vector<std::thread> threads;
    threads.reserve(static_cast<std::size_t>(count));
    for (int t = 0; t < count; ++t)
        threads.emplace_back([=, &work] {
            for (int y = t; y < rows; y += count) work(y);
        });
    for (std::thread& thread : threads) thread.join();
}

// The rays about one pixel, by offset in pixels.
class Neighbourhood {
  public:
    Neighbourhood(maths::CastTwin<double>& twin, int width, int height, int x, int y, double shown_m)
        : twin_(twin), width_(width), height_(height), x_(x), y_(y), shown_m_(shown_m) {}

    // The ray's hit compared with the distance shown: 0 within the tolerance, -1 nearer, 1 farther.
    int side(glm::dvec2 offset) const {
        double found =
            twin_.cast_pixel(2 * (x_ + 0.5 + offset.x) / width_ - 1, 2 * (y_ + 0.5 + offset.y) / height_ - 1)
                .distance_m;
        if (found < 0) found = HUGE_VAL;
        if (std::isinf(shown_m_)) return std::isinf(found) ? 0 : -1;
        if (std::isinf(found)) return 1;
        if (std::abs(shown_m_ - found) <= agreement * std::max(found, 1e-3)) return 0;
        return found < shown_m_ ? -1 : 1;
    }

    // The smallest offset that agrees, as near as the search tells; more than the limit where none does.
    double error(double limit_px) const {
        const int centre = side({0, 0});
        if (centre == 0) return 0;
        // Most often the distance changes steadily from pixel to pixel: up, down, left or right it is met.
        double nearest = HUGE_VAL;
        for (const glm::dvec2 way :
             {glm::dvec2(0, 1), glm::dvec2(0, -1), glm::dvec2(1, 0), glm::dvec2(-1, 0)})
            nearest = std::min(nearest, met_along(way, limit_px, centre));
        if (nearest <= limit_px) return nearest;
        constexpr int directions = 16;
        std::array<glm::dvec2, directions> unit{};
        for (int i = 0; i < directions; ++i) {
            const double angle = 2 * std::numbers::pi * i / directions;
            unit[i] = {std::cos(angle), std::sin(angle)};
        }
        // Rays that graze a crest change their hit by metres within millionths of a pixel: so far down.
        std::array<int, directions> inner{};
        inner.fill(centre);
        double inner_px = 0;
        for (double px = 1e-6; inner_px < limit_px; px *= px < 1e-3 ? 2 : 1.2) {
            const double ring_px = std::min(px, limit_px);
            std::array<int, directions> ring{};
            for (int i = 0; i < directions; ++i) {
                ring[i] = side(ring_px * unit[i]);
                if (ring[i] == 0) return ring_px;
            }
            // Between a nearer and a farther hit the distance shown lies, unless it is jumped over.
            for (int i = 0; i < directions; ++i) {
                if (ring[i] != inner[i] && meets(inner_px * unit[i], ring_px * unit[i], inner[i]))
                    return ring_px;
                const int next = (i + 1) % directions;
                if (ring[i] != ring[next] && meets(ring_px * unit[i], ring_px * unit[next], ring[i]))
                    return ring_px;
            }
            inner = ring;
            inner_px = ring_px;
        }
        return 2 * limit_px;
    }

  private:
    // The offset along a direction where the distance shown is met, or infinity.
    double met_along(glm::dvec2 way, double limit_px, int centre) const {
        double low = 0;
        double high = limit_px;
        const int end = side(high * way);
        if (end == 0 || end == centre) return end == 0 ? met_before(way, limit_px) : HUGE_VAL;
        for (int i = 0; i < 40; ++i) {
            const double middle = 0.5 * (low + high);
            const int here = side(middle * way);
            if (here == 0) return middle;
            (here == centre ? low : high) = middle;
        }
        return HUGE_VAL;
    }

    // The same where the limit itself agrees: the smallest power of a half of it that does.
    double met_before(glm::dvec2 way, double limit_px) const {
        double px = limit_px;
        while (px > 1e-7 && side(0.5 * px * way) == 0) px *= 0.5;
        return px;
    }

    bool meets(glm::dvec2 a, glm::dvec2 b, int side_a) const {
        for (int i = 0; i < 40; ++i) {
            const glm::dvec2 middle = 0.5 * (a + b);
            const int here = side(middle);
            if (here == 0) return true;
            (here == side_a ? a : b) = middle;
        }
        return false;
    }

    maths::CastTwin<double>& twin_;
    int width_;
    int height_;
    int x_;
    int y_;
    double shown_m_;
};

}  // namespace

Measure::Measure(const Grid& grid, std::vector<float> ground) : grid_(grid), twin_(grid, std::move(ground)) {
    const auto [low, high] = std::minmax_element(twin_.heights.begin(), twin_.heights.end());
    diagonal_m_ = std::hypot(grid.width_m(), grid.height_m(), *high - *low);
}

std::vector<double> Measure::reference(const Camera& camera, int width, int height) {
    twin_.look(grid_, camera, width, height);
    std::vector<double> distances(static_cast<std::size_t>(width) * height);
    over_rows(height, [&](int y) {
        for (int x = 0; x < width; ++x) {
            const double d =
                twin_.cast_pixel(2 * (x + 0.5) / width - 1, 2 * (y + 0.5) / height - 1).distance_m;
            distances[static_cast<std::size_t>(y) * width + x] = d < 0 ? HUGE_VAL : d;
        }
    });
    return distances;
}

double Measure::error_px(const Camera& camera, int width, int height, int x, int y, double distance_m,
                         double limit_px) {
    twin_.look(grid_, camera, width, height);
    return Neighbourhood(twin_, width, height, x, y, distance_m).error(limit_px);
}

PictureError Measure::compare(const Camera& camera, int width, int height,
                              const std::vector<float>& distances, double limit_px) {
    const std::vector<double> expected = reference(camera, width, height);
    std::vector<PictureError> rows(height);
    over_rows(height, [&](int y) {
        PictureError& row = rows[y];
        const auto at = [&](int i, int j) {
            return expected[static_cast<std::size_t>(std::clamp(j, 0, height - 1)) * width +
                            std::clamp(i, 0, width - 1)];
        };
        for (int x = 0; x < width; ++x) {
            const double shown = distances[static_cast<std::size_t>(y) * width + x];
            const double truth = at(x, y);
            row.wrong_coverage += std::isinf(shown) != std::isinf(truth) ? 1 : 0;
            if (!std::isinf(truth)) {
                ++row.pixels_hit;
                const double beside = std::max({at(x - 1, y), at(x + 1, y), at(x, y - 1), at(x, y + 1)});
                if (beside > 1.02 * truth) {
                    ++row.silhouettes;
                    row.silhouettes_missed += shown > 1.01 * truth ? 1 : 0;
                }
                if (!std::isinf(shown)) row.psnr_db += (shown - truth) * (shown - truth);
            }
            const double px = Neighbourhood(twin_, width, height, x, y, shown).error(limit_px);
            row.beyond += px > limit_px ? 1 : 0;
            row.mean_px += std::min(px, limit_px);
            row.largest_px = std::max(row.largest_px, std::min(px, limit_px));
        }
    });
    PictureError all;
    for (const PictureError& row : rows) {
        all.pixels_hit += row.pixels_hit;
        all.wrong_coverage += row.wrong_coverage;
        all.silhouettes += row.silhouettes;
        all.silhouettes_missed += row.silhouettes_missed;
        all.psnr_db += row.psnr_db;
        all.mean_px += row.mean_px;
        all.largest_px = std::max(all.largest_px, row.largest_px);
        all.beyond += row.beyond;
    }
    const double mean_square = all.psnr_db / std::max(1, all.pixels_hit);
    all.psnr_db = mean_square > 0 ? 10 * std::log10(diagonal_m_ * diagonal_m_ / mean_square) : HUGE_VAL;
    all.mean_px /= static_cast<double>(width) * height;
    return all;
}

}  // namespace talus::render
