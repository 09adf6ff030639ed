#pragma once
#include <atomic>
#include <functional>
#include <future>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/core/progress.h"

namespace talus::app {

/// Long work on a thread of its own, while the window stays alive. A job touches neither OpenGL nor the
/// session; what it returns is done on the window's thread when it has ended.
class Work {
  public:
    using Then = std::function<void()>;
    /// It may say how far it is, and ends early where it is told to.
    using Job = std::function<Then(const Progress&)>;

    /// Waits for jobs that were given up.
    ~Work();
    /// One job at a time: while one runs, start() does nothing. `can_cancel`: false for a job that replaces a
    /// file.
    void start(std::string name, Job job, bool can_cancel = true);
    bool can_cancel() const { return can_cancel_; }
    bool busy() const { return job_.has_value(); }
    const std::string& name() const { return name_; }
    /// The share of it that is done, where it says so.
    std::optional<double> share() const;
    /// Seconds since it was started.
    double seconds() const;

    /// Does what a job that has ended wants done. Rethrows what it threw.
    void poll();
    /// Gives the job up: it ends by itself, and nothing is done then.
    void cancel();

  private:
    std::string name_;
    double started_s_ = 0;
    bool can_cancel_ = true;
    // What a job and the window say to each other.
    struct Told {
        std::atomic<double> share = -1;
        std::atomic<bool> is_given_up = false;
    };
    std::shared_ptr<Told> told_;
    std::optional<std::future<Then>> job_;
    std::vector<std::future<Then>> given_up_;
};

}  // namespace talus::app
