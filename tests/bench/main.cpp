// Benchmarks: talus_bench NAME [SHADER_DIR] of the table below, or papers [TABLE [TERRAIN [METHOD]]], or
// flight FILE [--photo FILE] [--host-mib N] [--extent M] [--middle X,Y]. Figures are process CPU time, or
// wall time where a GPU draws; interleaved, medians (docs/benchmarks.md).
#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <exception>
#include <string>
#include <string_view>

#include "app/core/calibration.h"
#include "sim/gpu/context.h"
#include "sim/gpu/shader_text.h"
#include "tests/bench/measure.h"

namespace {

talus::bench::FlightRun flight_run(int argc, char** argv) {
    talus::bench::FlightRun run;
    std::vector<double> middle_m;
    CLI::App options("flies over a raster in tiles", "talus_bench flight");
    options.add_option("FILE", run.file)->required();
    options.add_option("--photo", run.photo, "over it");
    options.add_option("--gpu-mib", run.gpu_mib, "memory of the device for tiles");
    options.add_option("--photo-mib", run.photo_mib, "and for the photo's");
    options.add_option("--host-mib", run.host_mib, "memory that reading may keep");
    options.add_option("--extent", run.extent_m, "heights and lengths are shares of it, m");
    options.add_option("--middle", middle_m, "of the way: X,Y from the south-west sample, m")
        ->delimiter(',')
        ->expected(2);
    options.parse(argc - 1, argv + 1);
    if (!middle_m.empty()) run.middle_m = glm::dvec2(middle_m[0], middle_m[1]);
    return run;
}

struct Benchmark {
    std::string_view name;
    void (*run)(double patch_pixels);
};

// Those that take nothing but a folder of shaders.
constexpr std::array benchmarks = {
    Benchmark{"render", [](double) { talus::bench::bench_render(); }},
    Benchmark{"methods", talus::bench::bench_methods},
    Benchmark{"update", [](double) { talus::bench::bench_update(); }},
    Benchmark{"frame", talus::bench::bench_frame},
    Benchmark{"backdrop", talus::bench::bench_backdrop},
    Benchmark{"photo", [](double) { talus::bench::bench_photo(); }},
    Benchmark{"waves", [](double) { talus::bench::bench_waves(); }},
    Benchmark{"erosion", talus::bench::bench_erosion},
    Benchmark{"sculpt", talus::bench::bench_sculpt},
};

}  // namespace

int main(int argc, char** argv) {
    const std::string_view which = argc > 1 ? argv[1] : "";
    const auto* const chosen = std::find_if(benchmarks.begin(), benchmarks.end(),
                                            [&](const Benchmark& one) { return one.name == which; });
    const bool is_simple = chosen != benchmarks.end();
    if (!is_simple && which != "papers" && (which != "flight" || argc < 3)) {
        std::string names;
        for (const Benchmark& one : benchmarks)
            names += fmt::format("{}{}", names.empty() ? "" : "|", one.name);
        fmt::print(stderr,
                   "usage: talus_bench {} [SHADER_DIR], or talus_bench papers [TABLE [TERRAIN [METHOD]]], or "
                   "talus_bench flight FILE [--photo FILE] [--host-mib N] [--extent M] [--middle X,Y]\n",
                   names);
        return 2;
    }
    try {
        if (argc > 2 && is_simple) talus::gpu::use_shader_folder(argv[2]);
        const talus::gpu::Context context;
        fmt::print("{}\n", talus::gpu::describe(context.device()));
        talus::bench::take_clock_of(context.device());
        if (!context.device().software) fmt::print("a GPU draws: times are wall times\n");
        if (is_simple)
            chosen->run(talus::app::patch_pixels(context.device()));
        else if (which == "papers")
            talus::bench::bench_papers(talus::app::patch_pixels(context.device()), argc > 2 ? argv[2] : "",
                                       argc > 3 ? argv[3] : "", argc > 4 ? argv[4] : "");
        else
            talus::bench::bench_flight(flight_run(argc, argv));
    } catch (const std::exception& error) {
        fmt::print(stderr, "talus_bench: {}\n", error.what());
        return 1;
    }
    return 0;
}
