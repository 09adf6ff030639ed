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
    job_ = std::async(std::launch::async, std::move(job));
}

double Work::seconds() const {
    return wall_clock_s() - started_s_;
}

void Work::poll() {
    std::erase_if(given_up_, has_ended);
    if (!job_ || !has_ended(*job_)) return;
    std::future<Then> ended = std::move(*job_);
    job_.reset();
    ended.get()();
}

void Work::cancel() {
    if (job_) given_up_.push_back(std::move(*job_));
    job_.reset();
}

}  // namespace talus::app
