#pragma once
#include <functional>
#include <string>
#include <vector>

namespace talus::bench {

/// What is compared: runs once per call, on all threads it wants.
struct Contestant {
    std::string name;
    std::function<void()> run;
};

/// Median CPU seconds of each contestant over `rounds` interleaved rounds, after one that does not count.
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
/// patch_pixels: the hybrid's choice on this device.
void bench_frame(double patch_pixels);

}  // namespace talus::bench
