#include "render/view_range.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

#include "render/shading.h"

namespace talus::render {
namespace {

namespace bins {
#include "render/view_range_bins.glsl"
}

constexpr double quantile = 0.98;
constexpr double least_share = 0.02;  // of the largest value

// Not below the value.
double rounded_up(double value, EndsScale to) {
    constexpr std::array<double, 9> steps = {1, 1.5, 2, 3, 4, 5, 6, 8, 10};
    const double power = std::pow(10, std::floor(std::log10(value)));
    // What is a step but for rounding is that step.
    const double step = value / power * (1 - 1e-6);
    if (to == EndsScale::at_power_of_ten) return step > 1 ? 10 * power : power;
    return power * *std::lower_bound(steps.begin(), steps.end() - 1, step);
}

// The words that the device counted: bins, then the largest value.
double end_of(const std::vector<float>& words, EndsScale to) {
    const float largest = words[bins::range_bins];
    if (!(largest > 0) || !std::isfinite(largest)) return 0;
    const auto bin_of = [](float value) { return std::bit_cast<std::uint32_t>(value) >> bins::range_shift; };
    const auto count = [&](std::uint32_t bin) { return std::bit_cast<std::uint32_t>(words[bin]); };
    const std::uint32_t last = bin_of(largest);
    const std::uint32_t first = bin_of(static_cast<float>(least_share * largest));
    double above = 0;
    for (std::uint32_t bin = first; bin <= last; ++bin) above += count(bin);
    above *= 1 - quantile;
    std::uint32_t bin = last;
    for (double seen = count(bin); seen <= above && bin > first; seen += count(bin)) --bin;
    // To the bin's upper end, or as far as it is filled.
    const float end = std::bit_cast<float>((bin + 1) << bins::range_shift);
    return rounded_up(bin == last ? largest : end, to);
}

}  // namespace

const ViewNumber* scale_end_of(const View& view) {
    const auto found = std::find_if(view.numbers.begin(), view.numbers.end(),
                                    [](const ViewNumber& one) { return one.ends_scale != EndsScale::no; });
    return found == view.numbers.end() ? nullptr : &*found;
}

void ViewRange::start(const Terrain& terrain, const ViewSettings& settings) {
    if (!program_ || view_ != settings.view) {
        program_.emplace(std::vector<std::string>{"render/view_range.comp"},
                         std::vector<std::string>{"VIEW_FILE render/views/" + settings.view + ".glsl"});
        view_ = settings.view;
    }
    ends_ = scale_end_of(view_named(view_))->ends_scale;
    if (counts_.bytes() == 0)
        counts_ = gpu::Buffer("view range", (bins::range_bins + 1) * sizeof(std::uint32_t));
    counts_.fill(0);
    const View& view = view_named(settings.view);
    if (has_what_it_shows(view, terrain)) {
        const Grid& grid = terrain.grid();
        bind_layers(*program_, terrain, view);
        set_numbers(*program_, settings);
        program_->bind_sampled("ground", terrain.ground);
        program_->bind_storage("Range", counts_);
        program_->set("patches", glm::ivec2(grid.nx - 1, grid.ny - 1));
        constexpr int side = 16 * bins::range_side;
        program_->dispatch((grid.nx + side - 1) / side, (grid.ny + side - 1) / side);
        gpu::barrier({gpu::Use::buffer_transfer});
    }
    readback_.start(counts_, counts_.bytes());
}

std::optional<double> ViewRange::poll() {
    const auto words = readback_.poll();
    return words ? std::optional(end_of(*words, ends_)) : std::nullopt;
}

double ViewRange::wait() {
    return end_of(readback_.wait(), ends_);
}

}  // namespace talus::render
