#pragma once
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <filesystem>
#include <glm/glm.hpp>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "app/core/film.h"

namespace talus::app {

/// A film of what is shown, as long as it was shown. A thread hands the pictures to ffmpeg; those that come
/// faster than it takes them are left out. Where nothing new is shown for two seconds or longer, the film
/// shows the last picture for two.
class LiveFilm {
  public:
    /// Throws talus::Error as Film does.
    LiveFilm(const std::filesystem::path& path, glm::ivec2 size);
    /// Gives up a film that is not finished.
    ~LiveFilm();
    LiveFilm(const LiveFilm&) = delete;
    LiveFilm& operator=(const LiveFilm&) = delete;

    glm::ivec2 size() const { return size_; }
    /// This picture is shown from `at_s` on, seconds of a clock that does not go back: rows of RGB from the
    /// top. Does not wait. Throws talus::Error where ffmpeg takes no more.
    void show(std::vector<std::uint8_t> rgb, double at_s);
    /// Ends it at this time. Waits for ffmpeg. Throws talus::Error where the film could not be written.
    void finish(double at_s);
    /// Of the film so far, s.
    double seconds() const { return static_cast<double>(pictures_) / pictures_a_second; }

    static constexpr double pictures_a_second = 25;

  private:
    // A picture, and how often it is in the film.
    struct Shown {
        std::vector<std::uint8_t> rgb;
        std::int64_t times = 0;
    };
    void write();
    void stays_until(double until_s);
    void hand_over(double until_s);
    void end_thread();

    Film film_;
    glm::ivec2 size_;
    Shown last_;         // shown since then
    double last_s_ = 0;  // when it began
    double film_s_ = 0;  // what was shown before it
    std::int64_t pictures_ = 0;
    std::mutex mutex_;
    std::condition_variable news_;
    std::deque<Shown> waiting_;
    bool ends_ = false;
    std::string failure_;
    std::thread writer_;
};

}  // namespace talus::app
