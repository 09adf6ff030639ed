// Benchmarks: talus_bench render | methods | update | frame | waves | erosion | sculpt [SHADER_DIR], or
// papers [TABLE [TERRAIN [METHOD]]], or flight FILE [MIB [EXTENT_M X_M Y_M]]. Figures are process CPU time,
// or wall time where a GPU draws; interleaved, medians (docs/benchmarks.md).
#include <fmt/format.h>

#include <exception>
#include <string>
#include <string_view>

#include "app/core/calibration.h"
#include "sim/gpu/context.h"
#include "sim/gpu/shader_text.h"
#include "tests/bench/measure.h"

namespace {

// FILE [MIB [EXTENT_M X_M Y_M]]
talus::bench::FlightRun flight_run(int argc, char** argv) {
    talus::bench::FlightRun run;
    run.file = argv[2];
    if (argc > 3) run.gpu_mib = std::stoi(argv[3]);
    if (argc > 6) {
        run.extent_m = std::stod(argv[4]);
        run.middle_m = glm::dvec2(std::stod(argv[5]), std::stod(argv[6]));
    }
    return run;
}

}  // namespace

int main(int argc, char** argv) {
    const std::string_view which = argc > 1 ? argv[1] : "";
    if (which != "render" && which != "methods" && which != "update" && which != "frame" &&
        which != "waves" && which != "erosion" && which != "sculpt" && which != "papers" &&
        (which != "flight" || argc < 3)) {
        fmt::print(stderr,
                   "usage: talus_bench render|methods|update|frame|waves|erosion|sculpt [SHADER_DIR], or "
                   "talus_bench papers [TABLE [TERRAIN [METHOD]]], or talus_bench flight FILE [MIB [EXTENT_M "
                   "X_M Y_M]]\n");
        return 2;
    }
    try {
        if (argc > 2 && which != "papers" && which != "flight") talus::gpu::use_shader_folder(argv[2]);
        const talus::gpu::Context context;
        fmt::print("{}\n", talus::gpu::describe(context.device()));
        talus::bench::take_clock_of(context.device());
        if (!context.device().software) fmt::print("a GPU draws: times are wall times\n");
        if (which == "render")
            talus::bench::bench_render();
        else if (which == "methods")
            talus::bench::bench_methods(talus::app::patch_pixels(context.device()));
        else if (which == "frame")
            talus::bench::bench_frame(talus::app::patch_pixels(context.device()));
        else if (which == "waves")
            talus::bench::bench_waves();
        else if (which == "sculpt")
            talus::bench::bench_sculpt(talus::app::patch_pixels(context.device()));
        else if (which == "papers")
            talus::bench::bench_papers(talus::app::patch_pixels(context.device()), argc > 2 ? argv[2] : "",
                                       argc > 3 ? argv[3] : "", argc > 4 ? argv[4] : "");
        else if (which == "flight")
            talus::bench::bench_flight(flight_run(argc, argv));
        else if (which == "erosion")
            talus::bench::bench_erosion(talus::app::patch_pixels(context.device()));
        else
            talus::bench::bench_update();
    } catch (const std::exception& error) {
        fmt::print(stderr, "talus_bench: {}\n", error.what());
        return 1;
    }
    return 0;
}
