#pragma once
#include <functional>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "sim/gpu/context.h"

namespace talus::bench {

/// Of the picture that is drawn.
constexpr int width = 1280;
constexpr int height = 720;

/// What is compared: runs once per call, on all threads it wants.
struct Contestant {
    std::string name;
    std::function<void()> run;
};

/// Chooses the clock: process CPU time where a processor draws, which other programs on a shared machine do
/// not disturb; wall time where a GPU does, whose work no process's CPU time holds.
void take_clock_of(const gpu::Device& device);

/// Cores whose time that clock adds up, on the machines that figures are given for: two, or one for wall
/// time.
double busy_cores();

/// Seconds on that clock. Waits for a GPU to do what it was given.
double run_time_s();

/// Median seconds of each contestant over `rounds` interleaved rounds, after one that does not count.
std::vector<double> interleave(const std::vector<Contestant>& contestants, int rounds);

void bench_render();
/// patch_pixels: the hybrid's choice on this device.
void bench_methods(double patch_pixels);
void bench_update();
void bench_waves();
/// patch_pixels: the hybrid's choice on this device.
void bench_erosion(double patch_pixels);
/// patch_pixels: the hybrid's choice on this device.
void bench_sculpt(double patch_pixels);
/// What is flown over, and where.
struct FlightRun {
    std::string file;
    std::string photo;                   ///< laid over it; empty: none
    int gpu_mib = 128;                   ///< memory of the device for tiles
    int photo_mib = 128;                 ///< and for the photo's
    int host_mib = 512;                  ///< memory that reading may keep
    std::optional<double> extent_m;      ///< heights and lengths are shares of it; the terrain's shorter side
    std::optional<glm::dvec2> middle_m;  ///< of the way; the terrain's
};
/// Flies over a raster in tiles, along the ground and high up: what frames take while tiles come, against the
/// same frames with all tiles there; memory; pixels whose ground is farther off than the tolerance, and
/// whose rays were farther below the ground on their way.
/// Throws talus::Error where frames take longer than is promised (docs/benchmarks.md, "Flights"), pixels are
/// farther off, or memory is over what it may be.
void bench_flight(const FlightRun& run);
/// Writes out/papers: all tables, or the one of this name; on all terrains, or that of this name;
/// of flight and survey the rows alone that begin with a method's name.
/// patch_pixels: the hybrid's choice on this device.
void bench_papers(double patch_pixels, const std::string& only, const std::string& terrain,
                  const std::string& method);
/// patch_pixels: the hybrid's choice on this device.
void bench_frame(double patch_pixels);
/// A part with the rest of its terrain around it, against each of them alone.
/// patch_pixels: the hybrid's choice on this device.
void bench_backdrop(double patch_pixels);
/// A photo in tiles over terrain in tiles, against a picture held as a whole and the ground's materials.
void bench_photo();

}  // namespace talus::bench
