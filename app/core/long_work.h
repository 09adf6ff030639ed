#pragma once
#include <array>
#include <chrono>
#include <string>

namespace talus::app {

/// What is told of long work: "34 %, 20 s left"; no time before any share is done.
std::string share_and_time_left(double share, double passed_s);

/// Tells on stderr how far long work is and how long it will take. While one of these lives, Ctrl+C (and
/// SIGTERM and SIGHUP) ends the work instead of the program; a second one, more than half a second later,
/// ends the program. Signals that the program was started to ignore stay ignored. One at a time.
class LongWork {
  public:
    /// what: of the work, e.g. "writing 'alps.tif'".
    explicit LongWork(std::string what);
    ~LongWork();
    LongWork(const LongWork&) = delete;
    LongWork& operator=(const LongWork&) = delete;

    /// share: of the work that is done, 0 to 1. False: it is to end.
    bool operator()(double share);

  private:
    std::string what_;
    std::chrono::steady_clock::time_point start_;
    std::chrono::steady_clock::time_point told_;
    bool told_once_ = false;
    bool on_terminal_;
    std::array<void (*)(int), 3> before_{};
};

}  // namespace talus::app
