// Flights over a raster in tiles while its tiles come, against the same frames with all tiles there.
#include <fmt/format.h>
#include <pthread.h>
#include <time.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <fstream>
#include <random>
#include <string>

#include "app/core/tiled_terrain.h"
#include "render/tiled/tile_loading.h"
#include "render/tiled/tile_paging.h"
#include "render/tiled/tiled_renderer.h"
#include "sim/error.h"
#include "tests/bench/measure.h"

namespace talus::bench {
namespace {

constexpr int flight_frames = 150;   // a flight
constexpr int checked_pixels = 350;  // a frame
constexpr glm::ivec2 flown_size(width, height);
constexpr double flight_px = 2.0 / 3;

// What a frame may take longer than with all tiles there.
constexpr double most_times = 1.5;
constexpr double most_more_s = 0.010;

// CPU seconds of the calling thread.
double thread_s() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

// The CPU time of the thread that reads, told at any time. Where a GPU draws, frames are measured by wall
// time, and it counts for nothing.
class ReadTime {
  public:
    ReadSamples around(ReadSamples read) {
        return [this, read = std::move(read)](int level, const TileSamples& samples,
                                              std::vector<float>& heights) {
            if (!known_) {
                pthread_getcpuclockid(pthread_self(), &clock_);
                known_ = true;
            }
            read(level, samples, heights);
        };
    }
    double seconds() const {
        timespec now{};
        if (!known_ || busy_cores() == 1) return 0;
        clock_gettime(clock_, &now);
        return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
    }

  private:
    clockid_t clock_{};
    std::atomic<bool> known_ = false;
};

// MiB that the process has held at most.
double peak_mib() {
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);)
        if (line.starts_with("VmHWM:")) return std::stod(line.substr(6)) / 1024;
    return 0;
}

// The finest level's bilinear surface, read where it is asked for.
class FinestSurface {
  public:
    FinestSurface(const Grid& grid, ReadSamples read) : grid_(grid), read_(std::move(read)) {}

    // None beside the terrain.
    std::optional<double> height_m(glm::dvec2 place_m) {
        const glm::dvec2 at(grid_.column_of(place_m.x), grid_.row_of(place_m.y));
        if (at.x < 0 || at.y < 0 || at.x > grid_.nx - 1 || at.y > grid_.ny - 1) return std::nullopt;
        const glm::ivec2 patch = glm::min(glm::ivec2(at), glm::ivec2(grid_.nx, grid_.ny) - 2);
        read_(0, {patch, {2, 2}}, corners_);
        const glm::dvec2 in = at - glm::dvec2(patch);
        return std::lerp(std::lerp<double>(corners_[0], corners_[1], in.x),
                         std::lerp<double>(corners_[2], corners_[3], in.x), in.y);
    }

  private:
    Grid grid_;
    ReadSamples read_;
    std::vector<float> corners_;
};

class Flight {
  public:
    Flight(const app::TiledTerrain& terrain, int gpu_mib)
        : terrain_(terrain),
          finest_(terrain.tree.grid(), terrain.file.make_reader()),
          paged_(terrain.tree, terrain.bounds, app::slots_within(terrain, gpu_mib)),
          loaded_(terrain.tree, terrain.bounds, app::slots_within(terrain, gpu_mib)),
          loading_([&] { return terrain.file.make_reader(); }),
          paging_(terrain.tree, read_time_.around(terrain.file.make_reader())) {
        loading_.begin(paged_);
        loading_.begin(loaded_);
    }

    std::size_t device_bytes() const { return paged_.bytes(); }

    // Cameras so high over the ground along a line, with as much looked down.
    std::vector<render::Camera> way(glm::dvec2 middle, double height_m, double length_m, double down) {
        std::vector<render::Camera> cameras;
        double eye_m = -1e9;
        for (int frame = 0; frame < flight_frames; ++frame) {
            const double along = length_m * (static_cast<double>(frame) / (flight_frames - 1) - 0.5);
            const glm::dvec2 at = middle + along * glm::normalize(glm::dvec2(1, 0.4));
            // Rises with the ground ahead, and sinks slowly.
            double ground_m = finest_.height_m(at).value_or(terrain_.lowest_m);
            for (int k = 1; k <= 8; ++k)
                ground_m = std::max(
                    ground_m, finest_.height_m(at + k * height_m * glm::dvec2(0.9, 0.36)).value_or(ground_m) -
                                  0.5 * k * height_m);
            eye_m = std::max(ground_m + height_m, eye_m - 0.1 * height_m);
            const glm::dvec3 eye(at, eye_m);
            cameras.push_back({eye, eye + glm::dvec3(1, 0.4, -down), 50});
        }
        return cameras;
    }

    void fly(const std::string& name, const std::vector<render::Camera>& way) {
        std::vector<double> took_s;
        std::vector<double> loaded_s;
        std::vector<double> times;
        std::vector<double> follow_s;
        std::mt19937 random(5);
        int late = 0;
        int waiting = 0;
        std::size_t awaited = 0;
        int checked = 0;
        int off = 0;
        double reached_px = 0;
        double most_more = 0;
        render::ViewSettings settings;
        settings.sun = glm::normalize(glm::dvec3(-0.6, 0.5, 0.45));
        // The first frame of a flight waits for nothing either, but shaders are compiled in it.
        for (int warm = 0; warm < 2; ++warm)
            draw(paged_, way.front(), settings,
                 [&] { paging_.follow(paged_, way.front(), flown_size, flight_px); });
        for (const render::Camera& camera : way) {
            const double read_before = read_time_.seconds();
            const auto follow = [&] {
                const double begin = thread_s();
                const render::TileChoice& choice = paging_.follow(paged_, camera, flown_size, flight_px);
                follow_s.push_back(thread_s() - begin);
                reached_px = std::max(reached_px, choice.tolerance_px);
                waiting += choice.wanted.empty() ? 0 : 1;
                awaited += choice.wanted.size();
            };
            const double with_reading = draw(paged_, camera, settings, follow);
            took_s.push_back(with_reading - (read_time_.seconds() - read_before));
        }
        for (std::size_t frame = 0; frame < way.size(); ++frame) {
            const render::Camera& camera = way[frame];
            const double tolerance_px = loading_.load(loaded_, camera, flown_size, flight_px).tolerance_px;
            const double loaded =
                draw(loaded_, camera, settings, [&] { loaded_.look(camera, flown_size, flight_px); });
            const std::vector<float> depth = renderer_.read_depth(flown_size.x, flown_size.y);
            for (int k = 0; k < checked_pixels; ++k) {
                const glm::ivec2 pixel(static_cast<int>(random() % flown_size.x),
                                       static_cast<int>(random() % flown_size.y));
                const float distance_m = depth[static_cast<std::size_t>(pixel.y) * flown_size.x + pixel.x];
                if (std::isinf(distance_m)) continue;
                ++checked;
                off += off_px(camera, pixel, distance_m) > tolerance_px ? 1 : 0;
            }
            loaded_s.push_back(loaded);
            times.push_back(took_s[frame] / loaded);
            most_more = std::max(most_more, took_s[frame] - most_times * loaded);
            late += took_s[frame] > most_times * loaded + most_more_s ? 1 : 0;
        }
        const auto at = [](std::vector<double> values, double share) {
            std::sort(values.begin(), values.end());
            return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
        };
        fmt::print(
            "{:8}  frames {:5.1f} ms, of it tiles and their choice {:.1f}, all tiles there {:5.1f} ms; times "
            "{:.2f}, 9 of 10 {:.2f}, largest "
            "{:.2f}; "
            "beyond 1.5 times by at most {:.1f} ms, late {}; waiting for tiles {} of {}, for {:.1f} on "
            "average; "
            "tolerance reached {:.2f} px; {} of {} pixels farther off\n",
            name, 1e3 * at(took_s, 0.5), 1e3 * at(follow_s, 0.5), 1e3 * at(loaded_s, 0.5), at(times, 0.5),
            at(times, 0.9), at(times, 1), 1e3 * most_more, late, waiting, took_s.size(),
            static_cast<double>(awaited) / flight_frames, reached_px, off, checked);
        late_ += late;
        off_ += off;
    }

    void check() const {
        if (late_ > 0) throw Error(fmt::format("{} frames took longer than they may", late_));
        if (off_ > 0) throw Error(fmt::format("{} pixels are farther off than the tolerance", off_));
    }

  private:
    template <typename Follow>
    double draw(const render::TiledSurface& surface, const render::Camera& camera,
                const render::ViewSettings& settings, const Follow& follow) {
        const double begin = run_time_s();
        follow();
        renderer_.draw(surface, camera, settings, flown_size.x, flown_size.y);
        const std::vector<std::uint8_t> wait = renderer_.read_rgb(1, 1);
        return run_time_s() - begin;
    }

    // How far the finest surface is above or below what a pixel shows.
    double off_px(const render::Camera& camera, glm::ivec2 pixel, double distance_m) {
        const render::CameraRays rays = render::camera_rays(camera, flown_size.x, flown_size.y);
        const glm::dvec2 at(2 * (pixel.x + 0.5) / flown_size.x - 1, 1 - 2 * (pixel.y + 0.5) / flown_size.y);
        const glm::dvec3 way = glm::normalize(rays.middle + at.x * rays.right + at.y * rays.up);
        glm::dvec3 point = camera.eye + distance_m * way;
        const std::optional<double> ground_m = finest_.height_m(point);
        // On the terrain's sides there is no ground.
        if (!ground_m) return 0;
        point.z = *ground_m;
        const auto place = render::place_in_picture(camera, rays, point);
        return place ? glm::length(0.5 * (*place - at) * glm::dvec2(flown_size)) : 0;
    }

    const app::TiledTerrain& terrain_;
    FinestSurface finest_;
    render::TiledSurface paged_;
    render::TiledSurface loaded_;
    render::TileLoading loading_;
    render::TiledRenderer renderer_;
    ReadTime read_time_;
    int late_ = 0;
    int off_ = 0;
    render::TilePaging paging_;
};

}  // namespace

void bench_flight(const FlightRun& run) {
    constexpr int host_mib = 512;
    io::limit_read_memory(std::size_t{host_mib} << 20);
    const app::TiledTerrain terrain = app::open_tiled({run.file, {}}, app::on_terminal());
    const Grid& grid = terrain.tree.grid();
    Flight flight(terrain, run.gpu_mib);
    const double extent_m = run.extent_m.value_or(std::min(grid.width_m(), grid.height_m()));
    const glm::dvec2 middle = run.middle_m.value_or(0.5 * glm::dvec2(grid.width_m(), grid.height_m()));
    fmt::print("{} x {} samples, {:.1f} MiB of the device for tiles\n", grid.nx, grid.ny,
               static_cast<double>(flight.device_bytes()) / (1 << 20));
    flight.fly("ground", flight.way(middle, 0.004 * extent_m, 0.5 * extent_m, 0.25));
    flight.fly("high", flight.way(middle, 0.1 * extent_m, 0.6 * extent_m, 0.7));
    fmt::print("the process held at most {:.0f} MiB, the device's and a second set of tiles among them\n",
               peak_mib());
    flight.check();
}

}  // namespace talus::bench
