#include "app/core/live_film.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "sim/error.h"

namespace talus::app {
namespace {

// Pictures that wait for ffmpeg at most.
constexpr std::size_t most_waiting = 12;
constexpr double longest_still_s = 2;

}  // namespace

LiveFilm::LiveFilm(const std::filesystem::path& path, glm::ivec2 size)
    : film_(path, size), size_(size), writer_([this] { write(); }) {}

LiveFilm::~LiveFilm() {
    {
        const std::lock_guard lock(mutex_);
        waiting_.clear();
    }
    end_thread();
}

void LiveFilm::write() {
    while (true) {
        std::unique_lock lock(mutex_);
        news_.wait(lock, [this] { return ends_ || !waiting_.empty(); });
        if (waiting_.empty()) return;
        const Shown next = std::move(waiting_.front());
        waiting_.pop_front();
        lock.unlock();
        try {
            for (std::int64_t i = 0; i < next.times; ++i) film_.add(next.rgb);
        } catch (const std::exception& error) {
            const std::lock_guard again(mutex_);
            failure_ = error.what();
            return;
        }
    }
}

void LiveFilm::stays_until(double until_s) {
    film_s_ += std::clamp(until_s - last_s_, 0.0, longest_still_s);
    last_s_ = until_s;
}

// The last picture, for as long as it was shown.
void LiveFilm::hand_over(double until_s) {
    stays_until(until_s);
    last_.times = std::llround(film_s_ * pictures_a_second) - pictures_;
    // One that was shown for less than a picture of the film is in none.
    if (last_.times <= 0 || last_.rgb.empty()) return;
    pictures_ += last_.times;
    const std::lock_guard lock(mutex_);
    waiting_.push_back(std::move(last_));
    news_.notify_one();
}

void LiveFilm::show(std::vector<std::uint8_t> rgb, double at_s) {
    {
        const std::lock_guard lock(mutex_);
        if (!failure_.empty()) throw Error(failure_);
        if (waiting_.size() >= most_waiting && !last_.rgb.empty()) {
            // The one before stays until ffmpeg has caught up.
            stays_until(at_s);
            return;
        }
    }
    if (!last_.rgb.empty()) hand_over(at_s);
    last_.rgb = std::move(rgb);
    last_s_ = at_s;
}

void LiveFilm::finish(double at_s) {
    if (!last_.rgb.empty()) {
        // A film of one moment has a picture too.
        if (pictures_ == 0) film_s_ = std::max(film_s_, 1 / pictures_a_second);
        hand_over(at_s);
    }
    end_thread();
    if (!failure_.empty()) throw Error(failure_);
    film_.finish();
}

void LiveFilm::end_thread() {
    {
        const std::lock_guard lock(mutex_);
        ends_ = true;
    }
    news_.notify_one();
    if (writer_.joinable()) writer_.join();
}

}  // namespace talus::app
