// What the water costs: cell-updates a second, the share of the map that is wet, and error against run time.
#include <fmt/format.h>

#include <cmath>
#include <memory>

#include "app/claims/water_scenes.h"
#include "app/core/report.h"
#include "tests/bench/measure.h"

namespace talus::bench {

namespace {

using scenes::WaterRun;
using scenes::WaterScene;

// Waves of all lengths on rough ground; water everywhere where share is 1, else in a strip of that share.
WaterScene waves(int n, int order, double share) {
    WaterScene scene;
    scene.grid = {n, n, 10, 10};
    scene.settings.order = order;
    scene.settings.manning_s_per_m13 = 0.03;
    const double extent = n * 10;
    scene.bed = [=](double x, double y) {
        const double ground = 4 * std::sin(x / 170) * std::cos(y / 130) + std::sin(x / 31 + y / 47);
        return x > share * extent ? 100 + ground : ground;
    };
    const auto bed = scene.bed;
    scene.water = [=](double x, double y, double) {
        const double level = 20 + std::sin(x / 90) * std::sin(y / 110) + 0.5 * std::cos(x / 53 - y / 71);
        return glm::dvec3(std::max(0.0, level - bed(x, y)), 0, 0);
    };
    if (share == 0) {
        // A lake at rest.
        scene.bed = [](double x, double y) { return 4 * std::sin(x / 170) * std::cos(y / 130); };
        scene.water = [](double x, double y, double) {
            const auto z = static_cast<float>(4 * std::sin(x / 170) * std::cos(y / 130));
            return glm::dvec3(20 - static_cast<double>(z), 0, 0);
        };
    }
    return scene;
}

struct Case {
    Case(const WaterScene& scene, double tick) : run(scene.state(), scene.settings), tick_s(tick) {
        // Past the first moments, in which a lake finds out that it rests.
        run.tick(tick_s);
        run.tick(tick_s);
    }
    WaterRun run;
    double tick_s;
};

double substeps_of(const Case& c) {
    return static_cast<double>(c.run.water.work().substeps);
}

}  // namespace

void bench_waves() {
    constexpr int n = 1024;
    Case second(waves(n, 2, 1), 1);
    Case first(waves(n, 1, 1), 1);
    Case tenth(waves(n, 2, 0.1), 1);
    Case lake(waves(n, 2, 0), 1);
    std::vector<Case*> cases = {&second, &first, &tenth, &lake};
    std::vector<double> before;
    before.reserve(cases.size());
    for (const Case* c : cases) before.push_back(substeps_of(*c));
    std::vector<Contestant> contestants;
    contestants.reserve(cases.size());
    for (Case* c : cases) contestants.push_back({"", [c] { c->run.tick(c->tick_s); }});
    constexpr int rounds = 9;
    const std::vector<double> seconds = interleave(contestants, rounds);
    std::vector<double> each;
    each.reserve(cases.size());
    for (std::size_t i = 0; i < cases.size(); ++i)
        each.push_back(seconds[i] / ((substeps_of(*cases[i]) - before[i]) / (rounds + 1)));
    const double updates = busy_cores() * 1e-6 * static_cast<double>(n) * n;
    fmt::print(
        "{}², one sub-step; million cell-updates a second, on two busy cores where a processor draws\n", n);
    fmt::print("{:<34} {:>9} {:>9}\n", "", "ms", "M/s");
    fmt::print("{:<34} {:>9.2f} {:>9.1f}\n", "order 2, all wet", 1e3 * each[0], updates / each[0]);
    fmt::print("{:<34} {:>9.2f} {:>9.1f}\n", "order 1, all wet (two updates)", 1e3 * each[1],
               2 * updates / each[1]);
    fmt::print("{:<34} {:>9.2f}   {:.1f} times cheaper\n", "order 2, a tenth wet", 1e3 * each[2],
               each[0] / each[2]);
    fmt::print("{:<34} {:>9.2f}   {:.0f} times cheaper\n", "order 2, a lake at rest", 1e3 * each[3],
               each[0] / each[3]);

    fmt::print("\nerror against run time: relative L1 of depth, seconds\n");
    fmt::print("scene\torder\tn\terror\trun_time_s\tsubsteps\n");
    for (const auto& make : {scenes::stoker, scenes::thacker_radial, scenes::thacker_planar})
        for (const int order : {1, 2})
            for (const int samples : {64, 128, 256, 512}) {
                WaterScene scene = make(samples);
                scene.settings.order = order;
                WaterRun run(scene.state(), scene.settings);
                const double start = run_time_s();
                run.run(scene.tick_s, scene.end_s);
                const double run_s = run_time_s() - start;
                fmt::print("{}\t{}\t{}\t{:.3e}\t{:.3f}\t{}\n", scene.name, order, samples,
                           depth_error(scene, run.read(), scene.end_s), run_s, run.water.work().substeps);
            }
}

}  // namespace talus::bench
