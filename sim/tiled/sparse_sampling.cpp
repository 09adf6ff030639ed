#include "sim/tiled/sparse_sampling.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <exception>
#include <limits>
#include <mutex>
#include <thread>

#include "sim/tiled/void_filling.h"

namespace talus {
namespace {

using SamplingClock = std::chrono::steady_clock;

// The first reading has so many samples in a row and in a column.
constexpr int first_side = 4;
// It may take so many times as long as all readings are to.
constexpr double first_patience = 6;

// Reads samples in the middle of `count` equal parts of the terrain. Empty where it is too late. Whole rows
// belong to one thread: where a file keeps rows together they are unpacked once.
std::vector<float> read_evenly(glm::ivec2 samples, glm::ivec2 count, std::vector<ReadSamples>& readers,
                               SamplingClock::time_point end) {
    std::vector<float> heights(static_cast<std::size_t>(count.x) * count.y);
    std::atomic<int> next = 0;
    std::atomic<bool> late = false;
    std::exception_ptr failure;
    std::mutex failing;
    const auto middle = [](int part, int parts, int all) {
        return static_cast<int>((2 * static_cast<std::int64_t>(part) + 1) * all / (2 * parts));
    };
    const auto work = [&](const ReadSamples& read) {
        try {
            std::vector<float> one;
            for (int y = next++; y < count.y && !late; y = next++)
                for (int x = 0; x < count.x && !late; ++x) {
                    const glm::ivec2 place(middle(x, count.x, samples.x), middle(y, count.y, samples.y));
                    read(0, {place, glm::ivec2(1)}, one);
                    heights[static_cast<std::size_t>(y) * count.x + x] = one.front();
                    if (SamplingClock::now() > end) late = true;
                }
        } catch (...) {
            const std::lock_guard lock(failing);
            if (!failure) failure = std::current_exception();
            late = true;
        }
    };
    std::vector<std::thread> threads;
    for (std::size_t i = 1; i < readers.size(); ++i) threads.emplace_back(work, readers[i]);
    work(readers.front());
    for (std::thread& thread : threads) thread.join();
    if (failure) std::rethrow_exception(failure);
    if (late) heights.clear();
    return heights;
}

// A rectangle of heights over the same area as another one, from which it is interpolated.
std::vector<float> stretched(const std::vector<float>& heights, glm::ivec2 from, glm::ivec2 to) {
    std::vector<float> all(static_cast<std::size_t>(to.x) * to.y, std::numeric_limits<float>::quiet_NaN());
    const glm::dvec2 ratio = glm::dvec2(from) / glm::dvec2(to);
    fill_voids_from(heights, from, all, to,
                    [&](glm::ivec2 sample) { return (glm::dvec2(sample) + 0.5) * ratio - 0.5; });
    return all;
}

}  // namespace

std::vector<float> sample_sparsely(glm::ivec2 samples, glm::ivec2 size,
                                   const std::function<ReadSamples()>& make_reader, double budget_s) {
    std::vector<ReadSamples> readers;
    for (unsigned i = 0; i < std::max(1U, std::thread::hardware_concurrency()); ++i)
        readers.push_back(make_reader());
    const auto seconds_since = [](SamplingClock::time_point begin) {
        return std::chrono::duration<double>(SamplingClock::now() - begin).count();
    };
    const SamplingClock::time_point begin = SamplingClock::now();
    glm::ivec2 count = glm::min(glm::ivec2(first_side), size);
    const auto in_seconds = [](double seconds) {
        return SamplingClock::now() +
               std::chrono::duration_cast<SamplingClock::duration>(std::chrono::duration<double>(seconds));
    };
    std::vector<float> heights = read_evenly(samples, count, readers, in_seconds(first_patience * budget_s));
    if (heights.empty()) return {};
    double took_s = seconds_since(begin);
    // As many more as the time left is longer than the last reading took; no less than twice as many.
    for (double left_s = budget_s - took_s; count != size && left_s > 2 * took_s;
         left_s = budget_s - seconds_since(begin)) {
        const double factor = std::sqrt(left_s / std::max(took_s, 1e-4));
        const glm::ivec2 more = glm::min(glm::ivec2(glm::dvec2(count) * factor), size);
        const SamplingClock::time_point start = SamplingClock::now();
        std::vector<float> finer = read_evenly(samples, more, readers, in_seconds(budget_s));
        if (finer.empty()) break;
        heights = std::move(finer);
        count = more;
        took_s = seconds_since(start);
    }
    if (!fill_voids_by_means(heights, count)) return {};
    return stretched(heights, count, size);
}

}  // namespace talus
