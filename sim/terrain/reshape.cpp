#include "sim/terrain/reshape.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sim/error.h"
#include "sim/terrain/bed_beyond.h"
#include "sim/terrain/filter.h"
#include "sim/terrain/layers.h"

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

double sum_of(glm::vec2 words) {
    return static_cast<double>(words.x) + words.y;
}

// One number of each texel of a layer, at the float that it begins with, from one state into another.
struct NumberAt {
    const LayerDescription& layer;
    const LayerNumber& number;
    std::size_t word;

    std::size_t place(std::size_t texel) const {
        return texel * static_cast<std::size_t>(layer.words()) + word;
    }
    double get(std::span<const float> words, std::size_t texel) const {
        const float* at = &words[place(texel)];
        return number.two_words ? sum_of({at[0], at[1]}) : at[0];
    }
    void set(std::span<float> words, std::size_t texel, double value) const {
        float* at = &words[place(texel)];
        at[0] = static_cast<float>(value);
        if (number.two_words) at[1] = static_cast<float>(value - at[0]);
    }
};

// By how many taps each way of resampling finds a sample, along columns and rows.
struct Filter {
    Taps columns;
    Taps rows;
};

void resample_number(const NumberAt& number, const TerrainState& from, TerrainState& to,
                     const Filter& filter) {
    const std::span<const float> old_words = words_of(from, number.layer);
    const std::span<float> words = words_of(to, number.layer);
    std::vector<double> plane(from.grid.count());
    for (std::size_t i = 0; i < plane.size(); ++i) plane[i] = number.get(old_words, i);
    std::vector<double> resampled_plane = filtered(plane, from.grid.nx, filter.columns, filter.rows);
    if (number.number.resampling == Resampling::flow) {
        const double share = std::sqrt(to.grid.dx * to.grid.dy / (from.grid.dx * from.grid.dy));
        for (double& value : resampled_plane) value *= share;
    }
    for (std::size_t i = 0; i < resampled_plane.size(); ++i) number.set(words, i, resampled_plane[i]);
}

// A time of arrival beside a place where none arrived is no mean of both.
void take_nearest(const NumberAt& number, const TerrainState& from, TerrainState& to) {
    const std::span<const float> old_words = words_of(from, number.layer);
    const std::span<float> words = words_of(to, number.layer);
    const auto nearest = [](int at, int count, int old_count) {
        return static_cast<std::size_t>(std::lround(at * (old_count - 1.0) / (count - 1)));
    };
    std::size_t i = 0;
    for (int y = 0; y < to.grid.ny; ++y)
        for (int x = 0; x < to.grid.nx; ++x, ++i) {
            const std::size_t old =
                nearest(y, to.grid.ny, from.grid.ny) * from.grid.nx + nearest(x, to.grid.nx, from.grid.nx);
            number.set(words, i, number.get(old_words, old));
        }
}

// Every layer, texel by texel: `at` says which old sample a new one is.
template <typename At>
void move_samples(const TerrainState& from, TerrainState& to, At at) {
    for (const LayerDescription& layer : layers()) {
        const std::span<const float> old_words = words_of(from, layer);
        if (old_words.empty()) continue;
        make_layer(to, layer, to.grid.count());
        const auto size = static_cast<std::ptrdiff_t>(layer.words());
        auto texel = words_of(to, layer).begin();
        for (int y = 0; y < to.grid.ny; ++y)
            for (int x = 0; x < to.grid.nx; ++x) {
                const glm::ivec2 old = at(x, y);
                const auto old_texel =
                    old_words.begin() + (static_cast<std::ptrdiff_t>(old.y) * from.grid.nx + old.x) * size;
                texel = std::copy(old_texel, old_texel + size, texel);
            }
    }
}

// What a difference counts from: `at` says which old sample a new one is.
template <typename At>
void move_start(const TerrainState& from, TerrainState& to, At at) {
    if (from.start.empty()) return;
    to.start.reserve(to.grid.count());
    for (int y = 0; y < to.grid.ny; ++y)
        for (int x = 0; x < to.grid.nx; ++x) {
            const glm::ivec2 old = at(x, y);
            to.start.push_back(from.start[static_cast<std::size_t>(old.y) * from.grid.nx + old.x]);
        }
}

// The difference is resampled: where nothing has changed it stays 0, however the layers are resampled.
void resample_start(const TerrainState& from, TerrainState& to, const Filter& filter) {
    if (from.start.empty()) return;
    const std::vector<glm::vec2> old_ground = from.ground_words();
    std::vector<double> changes(old_ground.size());
    for (std::size_t i = 0; i < changes.size(); ++i)
        changes[i] = sum_of(old_ground[i]) - sum_of(from.start[i]);
    const std::vector<double> resampled_changes =
        filtered(changes, from.grid.nx, filter.columns, filter.rows);
    to.start = to.ground_words();
    for (std::size_t i = 0; i < to.start.size(); ++i) {
        if (resampled_changes[i] == 0) continue;
        const double height = sum_of(to.start[i]) - resampled_changes[i];
        to.start[i].x = static_cast<float>(height);
        to.start[i].y = static_cast<float>(height - to.start[i].x);
    }
}

// Of the ground beyond the edges: `at` says which place of the old map, or off it, a new one is.
template <typename At>
void move_bed_beyond(const TerrainState& from, TerrainState& to, At at) {
    if (from.bed_beyond.empty()) return;
    to.bed_beyond = bed_beyond_of(
        to.grid, [&at, bed = bed_around(from)](glm::ivec2 place) { return bed(at(place.x, place.y)); });
}

// Everything but grid, layers, start and the ground beyond.
TerrainState same_moment(const TerrainState& state) {
    TerrainState next;
    next.springs = state.springs;
    next.drives = state.drives;
    next.events = state.events;
    next.edges_since_s = state.edges_since_s;
    next.clock = state.clock;
    next.georeference = state.georeference;
    return next;
}

TerrainState turned_once(const TerrainState& state) {
    const Grid& old = state.grid;
    TerrainState next = same_moment(state);
    next.grid = {old.ny, old.nx, old.dy, old.dx};
    const auto old_place = [&](int x, int y) { return glm::ivec2(old.nx - 1 - y, x); };
    move_samples(state, next, old_place);
    move_start(state, next, old_place);
    move_bed_beyond(state, next, old_place);
    for (const LayerDescription& layer : layers()) {
        if (!layer.turn) continue;
        const std::span<float> words = words_of(next, layer);
        const auto size = static_cast<std::size_t>(layer.words());
        for (std::size_t at = 0; at < words.size(); at += size) layer.turn(words.subspan(at, size));
    }
    for (Spring& spring : next.springs)
        spring = {old.height_m() - spring.y_m, spring.x_m, spring.rate_m3_per_s};
    for (Event& event : next.events) {
        if (!event.breach) continue;
        for (glm::dvec2* end : {&event.breach->from_m, &event.breach->to_m})
            *end = {old.height_m() - end->y, end->x};
    }
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
    const Filter smooth = {resampling(old.nx, nx, 2, cubic), resampling(old.ny, ny, 2, cubic)};
    const Filter linear = {resampling(old.nx, nx, 1, straight), resampling(old.ny, ny, 1, straight)};
    for (const LayerDescription& layer : layers()) {
        if (words_of(state, layer).empty()) continue;
        make_layer(next, layer, next.grid.count());
        std::size_t word = 0;
        for (const LayerNumber& number : layer.numbers) {
            const NumberAt place{layer, number, word};
            if (number.resampling == Resampling::nearest)
                take_nearest(place, state, next);
            else
                resample_number(place, state, next,
                                number.resampling == Resampling::height ? smooth : linear);
            word += number.two_words ? 2 : 1;
        }
    }
    resample_start(state, next, linear);
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
    const auto old_place = [&](int x, int y) { return glm::ivec2(x + samples.x, y + samples.y); };
    move_samples(state, next, old_place);
    move_start(state, next, old_place);
    move_bed_beyond(state, next, old_place);
    const glm::dvec2 moved(samples.x * old.dx, (old.ny - samples.y - samples.height) * old.dy);
    for (Spring& spring : next.springs) {
        spring.x_m -= moved.x;
        spring.y_m -= moved.y;
    }
    std::erase_if(next.springs, [&](const Spring& spring) {
        return spring.x_m < 0 || spring.y_m < 0 || spring.x_m > next.grid.width_m() ||
               spring.y_m > next.grid.height_m();
    });
    for (Event& event : next.events) {
        if (!event.breach) continue;
        event.breach->from_m -= moved;
        event.breach->to_m -= moved;
    }
    drop_breaches_beside(next.grid, next.events);
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
