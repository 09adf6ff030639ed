#include "app/core/long_work.h"

#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <csignal>
#include <cstdint>
#include <ctime>
#include <utility>

namespace talus::app {
namespace {

std::atomic<std::int64_t> interrupted_ns = 0;  // when it was; 0: it was not

// Some senders (`timeout`, a shell that passes a signal on) send one request twice: to the program and to its
// group.
constexpr std::int64_t same_request_ns = 500'000'000;

std::int64_t now_ns() {
    timespec now{};
    ::clock_gettime(CLOCK_MONOTONIC, &now);
    return std::int64_t{now.tv_sec} * 1'000'000'000 + now.tv_nsec;
}

// A second request ends the program at once.
void interrupt(int signal) {
    const std::int64_t at_ns = now_ns();
    std::int64_t before_ns = 0;
    const bool is_first = interrupted_ns.compare_exchange_strong(before_ns, at_ns);
    if (!is_first && at_ns - before_ns > same_request_ns) {
        std::signal(signal, SIG_DFL);
        std::raise(signal);
    }
}

constexpr std::array<int, 3> ending_signals = {SIGINT, SIGTERM, SIGHUP};

// Work that ends sooner needs no words.
constexpr double quiet_s = 2;

std::string in_words(double seconds) {
    if (seconds < 90) return fmt::format("{:.0f} s", seconds);
    if (seconds < 5400) return fmt::format("{:.0f} min", seconds / 60);
    return fmt::format("{:.1f} h", seconds / 3600);
}

}  // namespace

std::string share_and_time_left(double share, double passed_s) {
    if (share <= 0) return "0 %";
    return fmt::format("{:.0f} %, {} left", 100 * share, in_words(passed_s * (1 - share) / share));
}

LongWork::LongWork(std::string what)
    : what_(std::move(what)),
      start_(std::chrono::steady_clock::now()),
      told_(start_),
      on_terminal_(::isatty(STDERR_FILENO) == 1) {
    interrupted_ns = 0;
    for (std::size_t i = 0; i < ending_signals.size(); ++i) {
        before_[i] = std::signal(ending_signals[i], interrupt);
        // What is to be ignored (SIGHUP under nohup) stays ignored.
        if (before_[i] == SIG_IGN) std::signal(ending_signals[i], SIG_IGN);
    }
}

LongWork::~LongWork() {
    if (told_once_ && on_terminal_) fmt::print(stderr, "\r\033[K");
    for (std::size_t i = 0; i < ending_signals.size(); ++i) std::signal(ending_signals[i], before_[i]);
}

bool LongWork::operator()(double share) {
    if (interrupted_ns != 0) return false;
    const auto now = std::chrono::steady_clock::now();
    const double passed_s = std::chrono::duration<double>(now - start_).count();
    const double since_s = std::chrono::duration<double>(now - told_).count();
    // Line after line where nothing can be written over.
    if (passed_s < quiet_s || share <= 0 || since_s < (on_terminal_ ? 0.5 : 10)) return true;
    told_ = now;
    told_once_ = true;
    const std::string told = fmt::format("{}: {}", what_, share_and_time_left(share, passed_s));
    if (on_terminal_)
        fmt::print(stderr, "\r{}\033[K", told);
    else
        fmt::print(stderr, "{}\n", told);
    std::fflush(stderr);
    return true;
}

}  // namespace talus::app
