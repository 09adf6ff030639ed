#include "sim/tiled/tile_bounds.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <exception>
#include <limits>
#include <mutex>
#include <thread>

namespace talus {
namespace {

// Tiles in a row and in a column that a thread takes at once: a file's own tiles reach over several, and are
// read once then.
constexpr int group_side = 8;

// The largest difference is sought in so many places at once.
constexpr std::size_t lanes = 16;

// Along one axis: the places where the difference of two surfaces can be largest, and where each lies between
// samples of both levels.
struct Crossings {
    std::vector<int> finer;  // sample before it, from the first one read on
    std::vector<float> finer_share;
    std::vector<int> coarser;
    std::vector<float> coarser_share;
    std::size_t count() const { return finer.size(); }
};

// first, last: of the finest level; ratio: finest samples for one of the coarser level; finer_first,
// coarser_first: samples that were read first.
Crossings crossings_of(int first, int last, double ratio, int finer_first, int coarser_first) {
    std::vector<double> all;
    for (int finest = first; finest <= last; ++finest) all.push_back(finest);
    const auto place_of = [&](double sample) { return (sample + 0.5) * ratio - 0.5; };
    for (double sample = std::ceil((first + 0.5) / ratio - 0.5); place_of(sample) < last; ++sample)
        if (place_of(sample) > first) all.push_back(place_of(sample));
    std::sort(all.begin(), all.end());
    Crossings crossings;
    for (const double place : all) {
        const double finer = std::min(std::floor(place), static_cast<double>(last - 1));
        const double at = (place + 0.5) / ratio - 0.5;
        const double coarser = std::floor(at);
        crossings.finer.push_back(static_cast<int>(finer) - finer_first);
        crossings.finer_share.push_back(static_cast<float>(place - finer));
        crossings.coarser.push_back(static_cast<int>(coarser) - coarser_first);
        crossings.coarser_share.push_back(static_cast<float>(at - coarser));
    }
    return crossings;
}

// A surface along a line of places: between two rows of samples, then between columns.
void along_line(const std::vector<float>& heights, int width, int row, float row_share,
                const std::vector<int>& columns, const std::vector<float>& shares, std::vector<float>& rows,
                std::vector<float>& line) {
    rows.resize(static_cast<std::size_t>(width));
    line.resize(columns.size());
    const float* above = heights.data() + static_cast<std::size_t>(row) * width;
    for (int i = 0; i < width; ++i) rows[i] = above[i] + row_share * (above[i + width] - above[i]);
    for (std::size_t i = 0; i < columns.size(); ++i) {
        const float* at = rows.data() + columns[i];
        line[i] = at[0] + shares[i] * (at[1] - at[0]);
    }
}

struct Samples {
    TileSamples where{};
    std::vector<float> heights;
};

float largest_difference(const std::vector<float>& a, const std::vector<float>& b) {
    std::array<float, lanes> most{};
    const std::size_t even = a.size() / lanes * lanes;
    for (std::size_t i = 0; i < even; i += lanes)
        for (std::size_t k = 0; k < lanes; ++k) {
            const float difference = std::abs(a[i + k] - b[i + k]);
            most[k] = most[k] < difference ? difference : most[k];
        }
    float largest = *std::max_element(most.begin(), most.end());
    for (std::size_t i = even; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
    return largest;
}

// One thread's part: a tile at a time.
class Worker {
  public:
    Worker(const TileTree& tree, ReadSamples read) : tree_(tree), read_(std::move(read)) {}

    TileBounds extent_of(const TileId& tile) {
        finest_.where = tree_.samples_of(tile);
        read_(tile.level, finest_.where, finest_.heights);
        const auto [low, high] = std::minmax_element(finest_.heights.begin(), finest_.heights.end());
        return {*low, *high, 0};
    }

    // Over the tile of the finest level that extent_of() was asked for last: how far the level's surface is
    // from the finest one.
    float error_over(const TileId& tile, int level) {
        const glm::ivec2 first = tree_.first_patch(tile);
        const glm::ivec2 last = tree_.last_patch(tile);
        const glm::ivec2 low = glm::floor(tree_.place_in(level, first));
        const glm::ivec2 high = glm::floor(tree_.place_in(level, last));
        coarser_.where = {low, high - low + 2};
        read_(level, coarser_.where, coarser_.heights);
        const glm::dvec2 ratio = tree_.level(level).ratio;
        const Crossings across = crossings_of(first.x, last.x, ratio.x, finest_.where.first.x, low.x);
        const Crossings down = crossings_of(first.y, last.y, ratio.y, finest_.where.first.y, low.y);
        float most = 0;
        for (std::size_t y = 0; y < down.count(); ++y) {
            along_line(finest_.heights, finest_.where.count.x, down.finer[y], down.finer_share[y],
                       across.finer, across.finer_share, rows_, finest_line_);
            along_line(coarser_.heights, coarser_.where.count.x, down.coarser[y], down.coarser_share[y],
                       across.coarser, across.coarser_share, rows_, coarser_line_);
            most = std::max(most, largest_difference(finest_line_, coarser_line_));
        }
        return most;
    }

  private:
    const TileTree& tree_;
    ReadSamples read_;
    Samples finest_;
    Samples coarser_;
    std::vector<float> rows_;
    std::vector<float> finest_line_;
    std::vector<float> coarser_line_;
};

// Whether a tile's samples, or those of a level over it, may be others where these of the finest level are.
bool touches(const TileTree& tree, const TileId& tile, int level, const TileSamples& changed) {
    // A sample stands for so many of the finest, and surfaces between samples reach to the next one.
    const int reach = 3 << level;
    const glm::ivec2 first = tree.first_patch(tile) - reach;
    const glm::ivec2 last = tree.last_patch(tile) + reach;
    return glm::all(glm::lessThanEqual(first, changed.first + changed.count - 1)) &&
           glm::all(glm::greaterThanEqual(last, changed.first));
}

struct TileGroup {
    int level;
    glm::ivec2 first;  // column and row of its first tile
    glm::ivec2 end;    // behind its last one
};

std::vector<TileGroup> groups_of(const TileTree& tree) {
    std::vector<TileGroup> groups;
    for (int level = 0; level <= tree.top_level(); ++level) {
        const glm::ivec2 tiles = tree.level(level).tiles;
        for (int row = 0; row < tiles.y; row += group_side)
            for (int column = 0; column < tiles.x; column += group_side) {
                const glm::ivec2 first(column, row);
                groups.push_back({level, first, glm::min(first + group_side, tiles)});
            }
    }
    return groups;
}

}  // namespace

std::vector<TileBounds> measure_tile_bounds(const TileTree& tree,
                                            const std::function<ReadSamples()>& make_reader,
                                            const std::function<bool(double)>& told,
                                            const BoundsBefore* before) {
    std::vector<TileBounds> bounds = before ? before->bounds : std::vector<TileBounds>(tree.count());
    for (TileBounds& one : bounds) one.error_m = 0;
    const auto is_to_do = [&](const TileId& tile, int level) {
        return !before || touches(tree, tile, level, before->changed);
    };
    const std::vector<TileGroup> groups = groups_of(tree);
    std::atomic<std::size_t> next = 0;
    std::atomic<bool> stopped = false;
    std::mutex merging;
    std::size_t done = 0;
    std::exception_ptr failure;
    const auto measure = [&](Worker& worker, const TileId& tile) {
        // What a coarser level changes reaches farther.
        const bool extent_is_to_do = is_to_do(tile, tile.level);
        const int reaching = tile.level == 0 ? tree.top_level() : tile.level;
        if (!is_to_do(tile, reaching)) {
            const std::lock_guard lock(merging);
            ++done;
            return;
        }
        const TileBounds extent = worker.extent_of(tile);
        std::vector<float> errors;
        for (int level = 1; tile.level == 0 && level <= tree.top_level(); ++level)
            errors.push_back(is_to_do(tile, level) ? worker.error_over(tile, level) : 0);
        const std::lock_guard lock(merging);
        TileBounds& here = bounds[tree.index_of(tile)];
        if (extent_is_to_do) {
            here.lowest_m = extent.lowest_m;
            here.highest_m = extent.highest_m;
        }
        for (int level = 1; level <= static_cast<int>(errors.size()); ++level) {
            TileBounds& above = bounds[tree.index_of({level, tile.column >> level, tile.row >> level})];
            above.error_m = std::max(above.error_m, errors[static_cast<std::size_t>(level) - 1]);
        }
        ++done;
    };
    const auto work = [&] {
        try {
            Worker worker(tree, make_reader());
            for (std::size_t index = next++; index < groups.size() && !stopped; index = next++) {
                const TileGroup& group = groups[index];
                for (int row = group.first.y; row < group.end.y; ++row)
                    for (int column = group.first.x; column < group.end.x && !stopped; ++column)
                        measure(worker, {group.level, column, row});
                const std::lock_guard lock(merging);
                if (told && !stopped && !told(static_cast<double>(done) / static_cast<double>(bounds.size())))
                    stopped = true;
            }
        } catch (...) {
            const std::lock_guard lock(merging);
            if (!failure) failure = std::current_exception();
            stopped = true;
        }
    };
    std::vector<std::thread> threads;
    for (unsigned i = 1; i < std::max(1u, std::thread::hardware_concurrency()); ++i)
        threads.emplace_back(work);
    work();
    for (std::thread& thread : threads) thread.join();
    if (failure) std::rethrow_exception(failure);
    if (stopped) return {};
    // Heights, shares and two interpolations are rounded to a few units in the last place.
    for (std::size_t index = tree.first_of(1); index < bounds.size(); ++index) {
        TileBounds& one = bounds[index];
        const float largest = std::max(std::abs(one.lowest_m), std::abs(one.highest_m));
        one.error_m += 16 * std::numeric_limits<float>::epsilon() * (largest + one.error_m);
        if (before) one.error_m = std::max(one.error_m, before->bounds[index].error_m);
    }
    return bounds;
}

}  // namespace talus
