// Benchmarks: talus_bench NAME [SHADER_DIR] of the table below, or papers [TABLE [TERRAIN [METHOD]]], or
// flight FILE [OPTIONS], which flight --help tells. Figures are process CPU time, or wall time where a GPU
// draws; interleaved, medians (docs/benchmarks.md).
#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <exception>
#include <string>
#include <string_view>
#include <vector>

#include "app/core/calibration.h"
#include "sim/gpu/context.h"
#include "sim/gpu/shader_text.h"
#include "tests/bench/measure.h"

namespace {

void add_options(CLI::App& options, talus::bench::FlightRun& run) {
    options.add_option("FILE", run.file, "a raster, flown over in tiles")->required();
    options.add_option("--photo", run.photo, "a photo that lies over it");
    options.add_option("--gpu-mib", run.gpu_mib, "memory of the device for tiles of the terrain");
    options.add_option("--photo-mib", run.photo_mib, "memory of the device for tiles of the photo");
    options.add_option("--host-mib", run.host_mib, "memory that reading may keep");
    options.add_option("--extent", run.extent_m, "heights and lengths of the way are shares of it, m");
    options
        .add_option_function<std::vector<double>>(
            "--middle", [&run](const std::vector<double>& m) { run.middle_m = glm::dvec2(m[0], m[1]); },
            "X,Y of the way's middle, from the south-west sample, m")
        ->delimiter(',')
        ->expected(2);
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
                   "talus_bench flight FILE [OPTIONS]\n",
                   names);
        return 2;
    }
    try {
        talus::bench::FlightRun flight;
        if (which == "flight") {
            CLI::App options("Flies over a raster in tiles, and measures it.", "talus_bench flight");
            add_options(options, flight);
            CLI11_PARSE(options, argc - 1, argv + 1);
        }
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
            talus::bench::bench_flight(flight);
    } catch (const std::exception& error) {
        fmt::print(stderr, "talus_bench: {}\n", error.what());
        return 1;
    }
    return 0;
}
