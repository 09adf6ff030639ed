#include "render/tiled/tile_paging.h"

#include <pthread.h>
#include <time.h>

#include <algorithm>
#include <chrono>
#include <iterator>
#include <utility>

namespace talus::render {
namespace {

// Tiles that a frame takes: it writes them to the device, and builds their pyramids.
constexpr std::size_t most_taken = 16;

// Tiles that have been read and wait for a frame.
constexpr std::size_t most_waiting = 32;

// The camera is looked for where it will be in so many frames.
constexpr double frames_ahead = 12;

// What cannot be read is tried again after a quarter of a second, then after twice as long each time.
constexpr std::chrono::milliseconds first_wait(250);
constexpr std::chrono::milliseconds longest_wait(8000);

}  // namespace

template <typename Surface>
Paging<Surface>::Paging(const TileTree& tree, typename Surface::ReadTile read)
    : tree_(tree), read_(std::move(read)), thread_([this] { read_on(); }) {}

template <typename Surface>
Paging<Surface>::~Paging() {
    {
        const std::lock_guard lock(mutex_);
        ending_ = true;
    }
    news_.notify_one();
    thread_.join();
}

template <typename Surface>
double Paging<Surface>::read_cpu_s() {
    clockid_t clock{};
    timespec taken{};
    if (pthread_getcpuclockid(thread_.native_handle(), &clock) != 0 || clock_gettime(clock, &taken) != 0)
        return 0;
    return static_cast<double>(taken.tv_sec) + 1e-9 * static_cast<double>(taken.tv_nsec);
}

template <typename Surface>
void Paging<Surface>::read_on() {
    std::unique_lock lock(mutex_);
    for (;;) {
        news_.wait(lock, [&] { return ending_ || (!asked_.empty() && come_.size() < most_waiting); });
        if (ending_) return;
        Read read{asked_.back(), {}, {}};
        asked_.pop_back();
        reading_ = read.tile;
        lock.unlock();
        try {
            read_(read.tile.level, Surface::samples_of(tree_, read.tile), read.samples);
        } catch (const std::exception& error) {
            read.error = error.what();
        }
        lock.lock();
        reading_.reset();
        come_.push_back(std::move(read));
    }
}

template <typename Surface>
const TileChoice& Paging<Surface>::follow(Surface& surface, const Camera& camera, glm::ivec2 size,
                                          double tolerance_px) {
    take(surface);
    const TileChoice& choice = surface.look(camera, size, tolerance_px);
    wanted_ = choice.wanted;
    follow_failures();
    on_their_way_ = wanted_.size() - failed_.size();
    std::vector<TileId> tiles = due(wanted_);
    // The thread has nothing better to do then.
    if (tiles.empty() && last_camera_ && !(*last_camera_ == camera))
        tiles = due(ahead(surface, camera, size, tolerance_px));
    last_camera_ = camera;
    ask(tiles);
    return choice;
}

template <typename Surface>
void Paging<Surface>::take(Surface& surface) {
    std::vector<Read> taken;
    {
        const std::lock_guard lock(mutex_);
        while (!come_.empty() && taken.size() < most_taken) {
            taken.push_back(std::move(come_.front()));
            come_.pop_front();
        }
    }
    news_.notify_one();
    for (const Read& read : taken) {
        if (!read.error.empty()) {
            note_failure(read);
            continue;
        }
        failures_.erase(tree_.index_of(read.tile));
        if (std::find(wanted_.begin(), wanted_.end(), read.tile) != wanted_.end())
            surface.put(read.tile, read.samples);
        else
            surface.put_aside(read.tile, read.samples);
    }
}

template <typename Surface>
void Paging<Surface>::note_failure(const Read& read) {
    last_error_ = read.error;
    const auto [failure, is_new] = failures_.try_emplace(tree_.index_of(read.tile));
    failure->second.wait =
        is_new ? first_wait : std::min<Clock::duration>(2 * failure->second.wait, longest_wait);
    failure->second.next = Clock::now() + failure->second.wait;
}

// What no picture wants any more is forgotten once it may be tried again.
template <typename Surface>
void Paging<Surface>::follow_failures() {
    const bool had_failed = !failed_.empty();
    const bool all_read = std::none_of(failed_.begin(), failed_.end(),
                                       [&](std::size_t index) { return failures_.contains(index); });
    std::set<std::size_t> wanted;
    for (const TileId& tile : wanted_) wanted.insert(tree_.index_of(tile));
    const Clock::time_point now = Clock::now();
    std::erase_if(failures_,
                  [&](const auto& one) { return !wanted.contains(one.first) && one.second.next <= now; });
    failed_.clear();
    for (const auto& [index, failure] : failures_)
        if (wanted.contains(index)) failed_.insert(index);
    if (!failed_.empty() && !had_failed)
        message_ = last_error_ + "; coarser tiles are shown there, and it is tried again";
    else if (failed_.empty() && had_failed && all_read)
        message_ = "tiles can be read again";
}

template <typename Surface>
bool Paging<Surface>::is_due(const TileId& tile) const {
    const auto failure = failures_.find(tree_.index_of(tile));
    return failure == failures_.end() || failure->second.next <= Clock::now();
}

template <typename Surface>
std::vector<TileId> Paging<Surface>::due(const std::vector<TileId>& tiles) const {
    std::vector<TileId> found;
    std::copy_if(tiles.begin(), tiles.end(), std::back_inserter(found),
                 [&](const TileId& tile) { return is_due(tile); });
    return found;
}

template <typename Surface>
std::vector<TileId> Paging<Surface>::ahead(Surface& surface, const Camera& camera, glm::ivec2 size,
                                           double tolerance_px) const {
    Camera later = camera;
    later.eye += frames_ahead * (camera.eye - last_camera_->eye);
    later.target += frames_ahead * (camera.target - last_camera_->target);
    if (later.eye == later.target) return {};
    return surface.look_ahead(later, size, tolerance_px);
}

template <typename Surface>
void Paging<Surface>::ask(const std::vector<TileId>& tiles) {
    {
        const std::lock_guard lock(mutex_);
        asked_.clear();
        for (const TileId& tile : tiles) {
            const bool has_come =
                std::any_of(come_.begin(), come_.end(), [&](const Read& read) { return read.tile == tile; });
            if (!has_come && reading_ != tile) asked_.push_back(tile);
        }
        std::reverse(asked_.begin(), asked_.end());
    }
    news_.notify_one();
}

template <typename Surface>
bool Paging<Surface>::has_news() const {
    const std::lock_guard lock(mutex_);
    const bool again = std::any_of(wanted_.begin(), wanted_.end(), [&](const TileId& tile) {
        const bool is_asked =
            reading_ == tile || std::find(asked_.begin(), asked_.end(), tile) != asked_.end();
        return failed_.contains(tree_.index_of(tile)) && is_due(tile) && !is_asked;
    });
    return again || !come_.empty();
}

template <typename Surface>
bool Paging<Surface>::reads() const {
    const std::lock_guard lock(mutex_);
    return reading_.has_value() || (!asked_.empty() && come_.size() < most_waiting);
}

template <typename Surface>
std::optional<std::string> Paging<Surface>::take_message() {
    return std::exchange(message_, std::nullopt);
}

template class Paging<TiledSurface>;
template class Paging<PhotoSurface>;

}  // namespace talus::render
