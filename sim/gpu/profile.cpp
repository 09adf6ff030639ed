#include "sim/gpu/profile.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <chrono>
#include <deque>

#include "sim/gpu/handle.h"
#include "sim/gpu/timestamp.h"

namespace talus::gpu {
namespace {

using Clock = std::chrono::steady_clock;

struct Span {
    std::string name;
    Handle<delete_query> first;
    Handle<delete_query> last;
    Clock::time_point begin;
    double cpu_ms = 0;
    bool ended = false;
};

// OpenGL's context is one of the thread's, and so is what is timed in it.
struct Timed {
    bool on = false;
    std::deque<Span> spans;  // oldest first
    int dropped = 0;         // spans that were in front of these
};
Timed& timed() {
    static thread_local Timed the;
    return the;
}

// Beyond this the oldest are forgotten: nobody asks.
constexpr std::size_t most_spans = 4096;

Handle<delete_query> timestamp() {
    GLuint name = 0;
    glCreateQueries(GL_TIMESTAMP, 1, &name);
    glQueryCounter(name, GL_TIMESTAMP);
    return Handle<delete_query>(name);
}

}  // namespace

void profile_passes(bool on) {
    timed().on = on;
    if (on) return;
    timed().dropped += static_cast<int>(timed().spans.size());
    timed().spans.clear();
}

PassSpan::PassSpan(std::string_view name) {
    if (!timed().on) return;
    auto& [on, spans, dropped] = timed();
    if (spans.size() >= most_spans) {
        spans.pop_front();
        ++dropped;
    }
    span_ = dropped + static_cast<int>(spans.size());
    spans.push_back({std::string(name), timestamp(), {}, Clock::now()});
}

PassSpan::~PassSpan() {
    auto& [on, spans, dropped] = timed();
    if (span_ < dropped) return;
    Span& span = spans[static_cast<std::size_t>(span_ - dropped)];
    span.cpu_ms = std::chrono::duration<double, std::milli>(Clock::now() - span.begin).count();
    span.last = timestamp();
    span.ended = true;
}

std::vector<PassTime> take_pass_times() {
    std::vector<PassTime> times;
    auto& [on, spans, dropped] = timed();
    while (!spans.empty() && spans.front().ended) {
        Span& span = spans.front();
        const std::optional<double> ms = milliseconds_between(span.first, span.last);
        if (!ms) break;
        auto found = std::find_if(times.begin(), times.end(),
                                  [&](const PassTime& time) { return time.name == span.name; });
        if (found == times.end()) found = times.insert(times.end(), PassTime{span.name});
        ++found->calls;
        found->cpu_ms += span.cpu_ms;
        found->device_ms += *ms;
        spans.pop_front();
        ++dropped;
    }
    return times;
}

}  // namespace talus::gpu
