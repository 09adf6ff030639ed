#include "app/core/work.h"

#include <chrono>
#include <utility>

#include "app/core/wall_clock.h"

namespace talus::app {
namespace {

bool has_ended(const std::future<Work::Then>& job) {
    return job.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
}

}  // namespace

Work::~Work() {
    cancel();
    for (const std::future<Then>& job : given_up_) job.wait();
}

void Work::start(std::string name, Job job, bool can_cancel) {
    if (busy()) return;
    name_ = std::move(name);
    started_s_ = wall_clock_s();
    can_cancel_ = can_cancel;
    told_ = std::make_shared<Told>();
    const Progress progress = [told = told_](double share) {
        told->share = share;
        return !told->is_given_up;
    };
    job_ = std::async(std::launch::async, [job = std::move(job), progress] { return job(progress); });
}

double Work::seconds() const {
    return wall_clock_s() - started_s_;
}

std::optional<double> Work::share() const {
    if (!busy() || told_->share < 0) return std::nullopt;
    return told_->share;
}

void Work::poll() {
    std::erase_if(given_up_, has_ended);
    if (!job_ || !has_ended(*job_)) return;
    std::future<Then> ended = std::move(*job_);
    job_.reset();
    ended.get()();
}

void Work::cancel() {
    if (job_) {
        told_->is_given_up = true;
        given_up_.push_back(std::move(*job_));
    }
    job_.reset();
}

}  // namespace talus::app
