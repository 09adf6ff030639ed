#include "tests/bench/measure.h"

#include <algorithm>

#include "app/report.h"

namespace talus::bench {

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
