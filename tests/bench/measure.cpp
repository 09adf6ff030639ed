#include "tests/bench/measure.h"

#include <sys/resource.h>

#include <algorithm>

namespace talus::bench {

double process_cpu_s() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    const auto seconds = [](const timeval& t) {
        return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
    };
    return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

std::vector<double> interleave(const std::vector<Contestant>& contestants, int rounds) {
    std::vector<std::vector<double>> times(contestants.size());
    for (int round = 0; round <= rounds; ++round)
        for (std::size_t i = 0; i < contestants.size(); ++i) {
            const double before = process_cpu_s();
            contestants[i].run();
            if (round > 0) times[i].push_back(process_cpu_s() - before);
        }
    std::vector<double> medians;
    for (std::vector<double>& t : times) {
        std::nth_element(t.begin(), t.begin() + t.size() / 2, t.end());
        medians.push_back(t[t.size() / 2]);
    }
    return medians;
}

}  // namespace talus::bench
