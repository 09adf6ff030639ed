#include "app/window/ground_probe.h"

#include <algorithm>
#include <utility>

#include "app/core/bilinear.h"

namespace talus::app {
namespace {

constexpr int probe_side = 48;  // samples that are read
constexpr int margin = 12;      // of them, beyond which they are read anew

}  // namespace

void GroundProbe::forget() {
    readback_.cancel();
    samples_.clear();
}

void GroundProbe::follow(const std::optional<GroundSamples>& ground) {
    if (auto samples = readback_.poll()) {
        samples_ = std::move(*samples);
        here_ = asked_;
    }
    if (!ground) return;
    const glm::ivec2 size = glm::min(ground->count, glm::ivec2(probe_side));
    const glm::ivec2 first =
        glm::clamp(glm::ivec2(ground->place) - size / 2, glm::ivec2(0), ground->count - size);
    const glm::ivec2 off = glm::abs(first - here_.first);
    const bool near_edge = glm::any(glm::greaterThan(off, glm::max(size / 2 - margin, 0)));
    const bool is_known = !samples_.empty() && here_.which == ground->which;
    if (readback_.pending() || (is_known && !near_edge && here_.changes == ground->changes)) return;
    const glm::ivec2 texel = ground->corner + first;
    readback_.start(*ground->heights, {texel.x, texel.y, size.x, size.y});
    asked_ = {first, size, ground->which, ground->changes};
}

std::optional<double> GroundProbe::height_m(const std::optional<GroundSamples>& ground) const {
    if (!ground || samples_.empty() || here_.which != ground->which) return std::nullopt;
    const glm::dvec2 at = ground->place - glm::dvec2(here_.first);
    if (!glm::all(glm::greaterThanEqual(at, glm::dvec2(0))) ||
        !glm::all(glm::lessThanEqual(at, glm::dvec2(here_.size - 1))))
        return std::nullopt;
    return bilinear(at, here_.size, [&](int column, int row) {
        return static_cast<double>(samples_[static_cast<std::size_t>(row) * here_.size.x + column]);
    });
}

}  // namespace talus::app
