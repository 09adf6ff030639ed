#include "sim/terrain/reshape.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sim/gpu/error.h"
#include "sim/terrain/filter.h"

namespace talus {
namespace {

double straight(double x) {
    return std::max(0.0, 1 - std::abs(x));
}

double cubic(double x) {
    const double a = std::abs(x);
    if (a < 1) return 1 + a * a * (1.5 * a - 2.5);
    if (a < 2) return 2 + a * (-4 + a * (2.5 - 0.5 * a));
    return 0;
}

Taps resampling(int count, int new_count, double kernel_reach, double (*kernel)(double)) {
    const double step = static_cast<double>(count - 1) / (new_count - 1);
    const double widened = std::max(1.0, step);
    return taps_of(
        count, new_count, [step](int i) { return i * step; }, kernel_reach * widened,
        [widened, kernel](double x) { return kernel(x / widened); });
}

glm::vec2 words_of(double height) {
    const auto high = static_cast<float>(height);
    return {high, static_cast<float>(height - high)};
}

double sum_of(glm::vec2 words) {
    return static_cast<double>(words.x) + words.y;
}

// Resamples one number of each texel of a layer: `get` takes it out, `set` puts it in.
template <typename Texel, typename Get, typename Set>
void resample_part(const std::vector<Texel>& from, int nx, const Taps& columns, const Taps& rows,
                   std::vector<Texel>& to, Get get, Set set) {
    std::vector<double> plane(from.size());
    std::transform(from.begin(), from.end(), plane.begin(), get);
    const std::vector<double> resampled_plane = filtered(plane, nx, columns, rows);
    to.resize(resampled_plane.size());
    for (std::size_t i = 0; i < to.size(); ++i) set(to[i], resampled_plane[i]);
}

// Every layer, texel by texel: `at` says which old sample a new one is.
template <typename At>
void move_samples(const TerrainState& from, TerrainState& to, At at) {
    const auto move = [&](const auto& old_layer, auto& new_layer) {
        if (old_layer.empty()) return;
        new_layer.resize(to.grid.count());
        for (int y = 0; y < to.grid.ny; ++y)
            for (int x = 0; x < to.grid.nx; ++x) {
                const glm::ivec2 old = at(x, y);
                new_layer[static_cast<std::size_t>(y) * to.grid.nx + x] =
                    old_layer[static_cast<std::size_t>(old.y) * from.grid.nx + old.x];
            }
    };
    move(from.bedrock, to.bedrock);
    move(from.regolith, to.regolith);
    move(from.water, to.water);
    move(from.inundation, to.inundation);
    move(from.suspended, to.suspended);
    move(from.painted, to.painted);
}

// Everything but grid and layers.
TerrainState same_moment(const TerrainState& state) {
    TerrainState next;
    next.springs = state.springs;
    next.edges_since_s = state.edges_since_s;
    next.clock = state.clock;
    next.georeference = state.georeference;
    return next;
}

TerrainState turned_once(const TerrainState& state) {
    const Grid& old = state.grid;
    TerrainState next = same_moment(state);
    next.grid = {old.ny, old.nx, old.dy, old.dx};
    move_samples(state, next, [&](int x, int y) { return glm::ivec2(old.nx - 1 - y, x); });
    for (glm::vec4& water : next.water) water = {water.x, water.y, -water.w, water.z};
    for (Spring& spring : next.springs)
        spring = {old.height_m() - spring.y_m, spring.x_m, spring.rate_m3_per_s};
    // What was turned lies there no more.
    next.georeference.reset();
    return next;
}

}  // namespace

TerrainState resampled(const TerrainState& state, int nx, int ny) {
    const Grid& old = state.grid;
    TerrainState next = same_moment(state);
    next.grid = {nx, ny, nx > 1 ? old.width_m() / (nx - 1) : 0, ny > 1 ? old.height_m() / (ny - 1) : 0};
    check_grid(next.grid);
    if (nx == old.nx && ny == old.ny) return state;
    const Taps smooth_columns = resampling(old.nx, nx, 2, cubic);
    const Taps smooth_rows = resampling(old.ny, ny, 2, cubic);
    const Taps columns = resampling(old.nx, nx, 1, straight);
    const Taps rows = resampling(old.ny, ny, 1, straight);
    const auto pair = [](glm::vec2& texel, double value) { texel = words_of(value); };
    resample_part(state.bedrock, old.nx, smooth_columns, smooth_rows, next.bedrock, sum_of, pair);
    resample_part(state.regolith, old.nx, columns, rows, next.regolith, sum_of, pair);
    if (!state.suspended.empty())
        resample_part(state.suspended, old.nx, columns, rows, next.suspended, sum_of, pair);
    if (!state.water.empty())
        resample_part(
            state.water, old.nx, columns, rows, next.water,
            [](const glm::vec4& water) {
                return sum_of({water.x, water.y});
            },
            [](glm::vec4& water, double depth) { water = glm::vec4(words_of(depth), 0, 0); });
    const auto each_component = [&](const auto& from, auto& to, int begin, int end) {
        if (from.empty()) return;
        for (int k = begin; k < end; ++k)
            resample_part(
                from, old.nx, columns, rows, to,
                [k](const auto& texel) { return static_cast<double>(texel[k]); },
                [k](auto& texel, double value) { texel[k] = static_cast<float>(value); });
    };
    each_component(state.water, next.water, 2, 4);
    each_component(state.painted, next.painted, 0, 4);
    each_component(state.inundation, next.inundation, 0, 1);
    // A time of arrival beside a place where none arrived is no mean of both.
    for (std::size_t i = 0; i < next.inundation.size(); ++i) {
        const auto x = static_cast<int>(i % static_cast<std::size_t>(nx));
        const auto y = static_cast<int>(i / static_cast<std::size_t>(nx));
        const auto old_x = static_cast<int>(std::lround(x * (old.nx - 1.0) / (nx - 1)));
        const auto old_y = static_cast<int>(std::lround(y * (old.ny - 1.0) / (ny - 1)));
        next.inundation[i].y = state.inundation[static_cast<std::size_t>(old_y) * old.nx + old_x].y;
    }
    if (next.georeference) {
        std::array<double, 6>& t = next.georeference->transform;
        const glm::dvec2 step(next.grid.dx / old.dx, next.grid.dy / old.dy);
        // Samples are the pixels' middles.
        t = {t[0] + 0.5 * (t[1] * (1 - step.x) + t[2] * (1 - step.y)), t[1] * step.x, t[2] * step.y,
             t[3] + 0.5 * (t[4] * (1 - step.x) + t[5] * (1 - step.y)), t[4] * step.x, t[5] * step.y};
    }
    return next;
}

gpu::Region samples_in(const Grid& grid, const Rectangle& rectangle) {
    const auto place = [](double v, int count) {
        return static_cast<int>(std::clamp(v, 0.0, static_cast<double>(count - 1)));
    };
    const int x0 = place(std::floor(grid.column_of(rectangle.west_m) + 1e-6), grid.nx);
    const int x1 = place(std::ceil(grid.column_of(rectangle.east_m) - 1e-6), grid.nx);
    const int y0 = place(std::floor(grid.row_of(rectangle.north_m) + 1e-6), grid.ny);
    const int y1 = place(std::ceil(grid.row_of(rectangle.south_m) - 1e-6), grid.ny);
    return {x0, y0, x1 - x0 + 1, y1 - y0 + 1};
}

TerrainState cropped(const TerrainState& state, const Rectangle& rectangle) {
    const Grid& old = state.grid;
    const gpu::Region samples = samples_in(old, rectangle);
    if (!(rectangle.east_m > rectangle.west_m && rectangle.north_m > rectangle.south_m) ||
        samples.width < min_samples || samples.height < min_samples)
        throw Error(
            fmt::format("a crop from {:.6g}, {:.6g} to {:.6g}, {:.6g} m leaves no terrain, it must hold two "
                        "samples a side "
                        "of 0, 0 to {:.6g}, {:.6g} m",
                        rectangle.west_m, rectangle.south_m, rectangle.east_m, rectangle.north_m,
                        old.width_m(), old.height_m()));
    TerrainState next = same_moment(state);
    next.grid = {samples.width, samples.height, old.dx, old.dy};
    move_samples(state, next, [&](int x, int y) { return glm::ivec2(x + samples.x, y + samples.y); });
    const glm::dvec2 moved(samples.x * old.dx, (old.ny - samples.y - samples.height) * old.dy);
    for (Spring& spring : next.springs) {
        spring.x_m -= moved.x;
        spring.y_m -= moved.y;
    }
    std::erase_if(next.springs, [&](const Spring& spring) {
        return spring.x_m < 0 || spring.y_m < 0 || spring.x_m > next.grid.width_m() ||
               spring.y_m > next.grid.height_m();
    });
    if (next.georeference) {
        std::array<double, 6>& t = next.georeference->transform;
        t[0] += t[1] * samples.x + t[2] * samples.y;
        t[3] += t[4] * samples.x + t[5] * samples.y;
    }
    return next;
}

TerrainState turned(const TerrainState& state, int quarters) {
    TerrainState next = state;
    for (int i = 0; i < ((quarters % 4) + 4) % 4; ++i) next = turned_once(next);
    return next;
}

}  // namespace talus
