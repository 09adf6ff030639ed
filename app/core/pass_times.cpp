#include "app/core/pass_times.h"

#include <algorithm>
#include <utility>

namespace talus::app {

std::optional<PassTimes::Gathered> PassTimes::follow(bool shown, double passed_s) {
    if (shown != profiling_) gpu::profile_passes(shown);
    profiling_ = shown;
    if (!shown) return std::nullopt;
    gathered_.span_s += passed_s;
    std::vector<gpu::PassTime>& passes = gathered_.passes;
    for (const gpu::PassTime& time : gpu::take_pass_times()) {
        auto found = std::find_if(passes.begin(), passes.end(),
                                  [&](const gpu::PassTime& pass) { return pass.name == time.name; });
        if (found == passes.end()) found = passes.insert(passes.end(), gpu::PassTime{time.name});
        found->calls += time.calls;
        found->cpu_ms += time.cpu_ms;
        found->device_ms += time.device_ms;
    }
    if (gathered_.span_s < 0.5) return std::nullopt;
    return std::exchange(gathered_, {});
}

}  // namespace talus::app
