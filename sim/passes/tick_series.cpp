#include "sim/passes/tick_series.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace talus {
namespace {

// Samples along the inflow edges, as metres.
double inflow_length_m(const WaterSettings& settings, const Grid& grid) {
    const std::array<double, 4> lengths = {grid.nx * grid.dx, grid.nx * grid.dx, grid.ny * grid.dy,
                                           grid.ny * grid.dy};
    double length_m = 0;
    for (std::size_t edge = 0; edge < 4; ++edge)
        if (settings.edges[edge] == EdgeKind::inflow) length_m += lengths[edge];
    return length_m;
}

// Inflow over all inflow edges against the time since the start, m³/s: rise, peak and fall.
TimeSeries hydrograph(const WaterSettings& settings) {
    const double peak = settings.inflow_m3_per_s;
    std::vector<TimeSeries::Row> rows;
    if (settings.inflow_rise_s > 0) rows.push_back({0, 0});
    rows.push_back({settings.inflow_rise_s, peak});
    if (settings.inflow_fall_s > 0) rows.push_back({settings.inflow_rise_s + settings.inflow_fall_s, 0});
    return TimeSeries(std::move(rows));
}

// The wave maker's height above the still level at a time since the start, m.
double wave_at(const WaterSettings& settings, double time_s) {
    if (settings.wave_form == WaveForm::series) {
        const TimeSeries& table = settings.driven.wave_height_m;
        return table.empty() ? 0 : table.at(settings.driven.since_s + time_s);
    }
    if (settings.wave_form == WaveForm::sine) {
        // Grows over the first period: a wave that begins at once sends a step ahead.
        const double grown = std::min(1.0, time_s / settings.wave_period_s);
        return settings.wave_height_m * grown *
               std::sin(2 * std::numbers::pi * time_s / settings.wave_period_s);
    }
    // Begins where the wave is a thousandth of its height, Synolakis 1987 (2.4).
    const double d = settings.wave_depth_m;
    const double height = settings.wave_height_m;
    if (height <= 0) return 0;
    const double gamma = std::sqrt(3 * height / (4 * d)) / d;
    const double celerity = std::sqrt(settings.gravity_m_per_s2 * (d + height));
    const double start = std::acosh(std::sqrt(1000.0)) / gamma;
    const double crest = std::cosh(gamma * (start - celerity * time_s));
    return height / (crest * crest);
}

}  // namespace

std::vector<float> tick_series(const WaterSettings& settings, const Grid& grid, double tick_s,
                               double start_s) {
    constexpr double mm_per_h = 1e-3 / 3600;
    const WaterDrives& driven = settings.driven;
    const double step_s = tick_s / glsl::tick_series_steps;
    std::vector<float> series(glsl::tick_series_tables * glsl::tick_series_points, 0);
    const auto fill = [&](int table, int count, const auto& value_at) {
        float* first = series.data() + static_cast<std::ptrdiff_t>(table) * glsl::tick_series_points;
        for (int i = 0; i < count; ++i) first[i] = static_cast<float>(value_at(start_s + step_s * i));
    };

    if (const double length_m = inflow_length_m(settings, grid); length_m > 0) {
        const bool by_table = !driven.inflow_m3_per_s.empty();
        const TimeSeries inflow = by_table ? driven.inflow_m3_per_s : hydrograph(settings);
        const double since_s = by_table ? driven.since_s : 0;
        fill(glsl::series_inflow, glsl::tick_series_steps,
             [&](double at_s) { return inflow.mean(since_s + at_s, since_s + at_s + step_s) / length_m; });
    }
    // Settings without rain in this tick may have lost it on purpose: where the mask that it goes by was
    // never painted.
    if (settings.rain_m_per_s > 0)
        fill(glsl::series_rain, glsl::tick_series_steps, [&](double at_s) {
            if (driven.rain_mm_per_h.empty()) return settings.rain_m_per_s;
            return driven.rain_mm_per_h.mean(driven.since_s + at_s, driven.since_s + at_s + step_s) *
                   mm_per_h;
        });
    fill(glsl::series_wave, glsl::tick_series_points, [&](double at_s) { return wave_at(settings, at_s); });
    fill(glsl::series_level, glsl::tick_series_points, [&](double at_s) {
        return driven.sea_level_m.empty() ? settings.level_m : driven.sea_level_m.at(driven.since_s + at_s);
    });
    return series;
}

}  // namespace talus
