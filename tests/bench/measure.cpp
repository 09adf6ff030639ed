#include "tests/bench/measure.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <chrono>

#include "app/core/report.h"

namespace talus::bench {
namespace {

bool waits_for_device = false;

}  // namespace

void take_clock_of(const gpu::Device& device) {
    waits_for_device = !device.software;
}

double busy_cores() {
    return waits_for_device ? 1 : 2;
}

double run_time_s() {
    if (!waits_for_device) return app::process_cpu_s();
    glFinish();
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

std::vector<double> interleave(const std::vector<Contestant>& contestants, int rounds) {
    std::vector<std::vector<double>> times(contestants.size());
    for (int round = 0; round <= rounds; ++round)
        for (std::size_t i = 0; i < contestants.size(); ++i) {
            const double before = run_time_s();
            contestants[i].run();
            if (round > 0) times[i].push_back(run_time_s() - before);
        }
    std::vector<double> medians;
    for (std::vector<double>& t : times) {
        std::nth_element(t.begin(), t.begin() + t.size() / 2, t.end());
        medians.push_back(t[t.size() / 2]);
    }
    return medians;
}

}  // namespace talus::bench
