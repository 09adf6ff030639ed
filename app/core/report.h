#pragma once
#include <string>

#include "sim/gpu/context.h"
#include "sim/simulation.h"

namespace talus::app {

/// What a run reports: numbers for machines, and the sentences that people get on stderr.
struct RunFigures {
    gpu::Device device;
    std::int64_t ticks = 0;
    double wall_s = 0;
    double cpu_s = 0;
};

/// The report of a run that ended in this state, as JSON; volumes in m³, speeds in m/s.
std::string run_report(const RunFigures& figures, const TerrainState& state, Simulation& simulation);

/// Prints a note to stderr, one line.
void say(const std::string& message);

/// Wall seconds since the program was loaded.
double seconds_since_start();

/// CPU seconds of this process so far, all threads.
double process_cpu_s();

}  // namespace talus::app
