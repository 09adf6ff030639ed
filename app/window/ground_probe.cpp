#include "app/window/ground_probe.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace talus::app {
namespace {

constexpr int probe_side = 48;  // samples that are read
constexpr int margin = 12;      // of them, beyond which they are read anew

}  // namespace

void GroundProbe::forget() {
    readback_.cancel();
    samples_.clear();
}

void GroundProbe::follow(const Terrain& terrain, glm::dvec2 place_m) {
    if (auto samples = readback_.poll()) {
        samples_ = std::move(*samples);
        here_ = asked_;
        changes_ = asked_changes_;
    }
    const Grid& grid = terrain.grid();
    const int column = static_cast<int>(std::clamp(grid.column_of(place_m.x), 0.0, grid.nx - 1.0));
    const int row = static_cast<int>(std::clamp(grid.row_of(place_m.y), 0.0, grid.ny - 1.0));
    const int width = std::min(probe_side, grid.nx);
    const int height = std::min(probe_side, grid.ny);
    const gpu::Region wanted{std::clamp(column - width / 2, 0, grid.nx - width),
                             std::clamp(row - height / 2, 0, grid.ny - height), width, height};
    const bool near_edge = std::abs(wanted.x - here_.x) > std::max(width / 2 - margin, 0) ||
                           std::abs(wanted.y - here_.y) > std::max(height / 2 - margin, 0);
    if (readback_.pending() || (!samples_.empty() && !near_edge && changes_ == terrain.tiles.now())) return;
    readback_.start(terrain.ground, wanted);
    asked_ = wanted;
    asked_changes_ = terrain.tiles.now();
}

std::optional<double> GroundProbe::height_m(const Grid& grid, glm::dvec2 place_m) const {
    // Who stands on the outermost samples is not beside the terrain by rounding.
    constexpr double rounding = 1e-9;
    const glm::dvec2 asked(grid.column_of(place_m.x), grid.row_of(place_m.y));
    const double column = std::clamp(asked.x, 0.0, grid.nx - 1.0);
    const double row = std::clamp(asked.y, 0.0, grid.ny - 1.0);
    const bool beside = std::abs(asked.x - column) > rounding || std::abs(asked.y - row) > rounding;
    if (samples_.empty() || beside) return std::nullopt;
    const double u = column - here_.x;
    const double v = row - here_.y;
    if (u < 0 || v < 0 || u > here_.width - 1 || v > here_.height - 1) return std::nullopt;
    const int x = std::min(static_cast<int>(u), here_.width - 2);
    const int y = std::min(static_cast<int>(v), here_.height - 2);
    const auto at = [&](int i, int j) {
        return static_cast<double>(samples_[static_cast<std::size_t>(y + j) * here_.width + x + i]);
    };
    return std::lerp(std::lerp(at(0, 0), at(1, 0), u - x), std::lerp(at(0, 1), at(1, 1), u - x), v - y);
}

}  // namespace talus::app
