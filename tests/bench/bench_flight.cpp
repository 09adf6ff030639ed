// Flights over a raster in tiles while its tiles come, against the same frames with all tiles there.
#include <fmt/format.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <memory>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "app/core/draping.h"
#include "app/core/paged_photo.h"
#include "app/core/tiled_terrain.h"
#include "render/tiled/tile_loading.h"
#include "render/tiled/tile_paging.h"
#include "render/tiled/tiled_renderer.h"
#include "sim/error.h"
#include "sim/io/tiled_file.h"
#include "tests/bench/finest_surface.h"
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

// What the process may hold beside both flights' tiles and what reading keeps: Talus, OpenGL and its
// compiler.
constexpr double most_beside_mib = 512;

// CPU seconds of the calling thread.
double thread_s() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double mib(std::size_t bytes) {
    return static_cast<double>(bytes) / (1 << 20);
}

// MiB that the process holds now.
double held_mib() {
    std::ifstream status("/proc/self/statm");
    std::size_t all = 0;
    std::size_t resident = 0;
    status >> all >> resident;
    return mib(resident * static_cast<std::size_t>(sysconf(_SC_PAGESIZE)));
}

// What is held, MiB.
struct Held {
    double reading = 0;
    double process = 0;

    void grow_to(const Held& now) {
        reading = std::max(reading, now.reading);
        process = std::max(process, now.process);
    }
};

class Flight {
  public:
    Flight(const app::TiledTerrain& terrain, const FlightRun& run)
        : terrain_(terrain),
          run_(run),
          finest_(terrain),
          paged_(terrain.tree, terrain.bounds, app::slots_within(terrain, run.gpu_mib)),
          loaded_(terrain.tree, terrain.bounds, app::slots_within(terrain, run.gpu_mib)),
          loading_([&] { return terrain.make_reader(); }),
          paging_(terrain.tree, terrain.make_reader()) {
        loading_.begin(paged_);
        loading_.begin(loaded_);
        if (run.photo.empty()) return;
        const app::Draping draping = app::open_draping(run.photo, terrain.file.georeference());
        if (!draping.photo) throw Error(fmt::format("'{}' is no photo that is read in tiles", run.photo));
        for (auto* photo : {&paged_photo_, &loaded_photo_})
            *photo = std::make_unique<app::PagedPhoto>(
                draping.photo, terrain.tree.grid(), terrain.file.georeference(),
                heights_between(terrain.tree, terrain.bounds), run.photo_mib);
    }

    // Of the device, for what comes while it is flown.
    std::size_t tile_bytes() const { return paged_.bytes(); }
    std::size_t photo_bytes() const { return paged_photo_ ? paged_photo_->surface().bytes() : 0; }

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
        Seen seen;
        Held most;
        double reached_px = 0;
        double most_more = 0;
        render::ViewSettings settings;
        settings.sun = glm::normalize(glm::dvec3(-0.6, 0.5, 0.45));
        const auto follow = [&](const render::Camera& camera) -> const render::TileChoice& {
            if (paged_photo_) paged_photo_->follow(camera, flown_size);
            return paging_.follow(paged_, camera, flown_size, flight_px);
        };
        // The first frame of a flight waits for nothing either, but shaders are compiled in it.
        for (int warm = 0; warm < 2; ++warm)
            draw(paged_, paged_photo_.get(), way.front(), settings, [&] { follow(way.front()); });
        for (const render::Camera& camera : way) {
            const auto look = [&] {
                const double begin = thread_s();
                const render::TileChoice& choice = follow(camera);
                follow_s.push_back(thread_s() - begin);
                const std::size_t of_photo = paged_photo_ ? paged_photo_->awaited_tiles() : 0;
                reached_px = std::max(reached_px, choice.tolerance_px);
                waiting += choice.wanted.size() + of_photo == 0 ? 0 : 1;
                awaited += choice.wanted.size() + of_photo;
            };
            took_s.push_back(draw(paged_, paged_photo_.get(), camera, settings, look));
            most.grow_to({mib(io::read_memory_bytes()), held_mib()});
        }
        for (std::size_t frame = 0; frame < way.size(); ++frame) {
            const render::Camera& camera = way[frame];
            const double tolerance_px = loading_.load(loaded_, camera, flown_size, flight_px).tolerance_px;
            if (loaded_photo_) {
                loaded_photo_->begin_still(camera, flown_size);
                loaded_photo_->wait_for_still(camera, flown_size);
                if (const auto failure = loaded_photo_->failure()) throw Error(*failure);
            }
            const double loaded = draw(loaded_, loaded_photo_.get(), camera, settings, [&] {
                if (loaded_photo_) loaded_photo_->follow(camera, flown_size);
                loaded_.look(camera, flown_size, flight_px);
            });
            const std::vector<float> depth = renderer_.read_depth(flown_size.x, flown_size.y);
            for (int k = 0; k < checked_pixels; ++k) {
                const glm::ivec2 pixel(static_cast<int>(random() % flown_size.x),
                                       static_cast<int>(random() % flown_size.y));
                check(camera, pixel, depth[static_cast<std::size_t>(pixel.y) * flown_size.x + pixel.x],
                      tolerance_px, seen);
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
            "tolerance reached {:.2f} px; {} of {} pixels farther off; {} of {} rays pass through\n",
            name, 1e3 * at(took_s, 0.5), 1e3 * at(follow_s, 0.5), 1e3 * at(loaded_s, 0.5), at(times, 0.5),
            at(times, 0.9), at(times, 1), 1e3 * most_more, late, waiting, took_s.size(),
            static_cast<double>(awaited) / flight_frames, reached_px, seen.off, seen.hits, seen.passed,
            seen.rays);
        fmt::print("          at most held: by reading {:.1f} of {} MiB, by the process {:.0f} MiB{}\n",
                   most.reading, run_.host_mib, most.process,
                   loaded_photo_
                       ? fmt::format("; the photo's texels at most {:.2f} px", loaded_photo_->largest_px())
                       : "");
        late_ += late;
        off_ += seen.off;
        passed_ += seen.passed;
        const double all_mib = run_.host_mib + 2 * (mib(tile_bytes()) + mib(photo_bytes())) + most_beside_mib;
        if (most.reading > run_.host_mib || most.process > all_mib) over_ = true;
        finest_.forget();
    }

    void check() const {
        if (late_ > 0) throw Error(fmt::format("{} frames took longer than they may", late_));
        if (off_ > 0) throw Error(fmt::format("{} pixels are farther off than the tolerance", off_));
        if (passed_ > 0) throw Error(fmt::format("{} rays pass through the finest surface", passed_));
        if (over_) throw Error("reading or the process holds more memory than it may");
    }

  private:
    // Pixels that were looked at against the finest surface.
    struct Seen {
        int hits = 0;
        int off = 0;  // of them: the surface is farther above or below than the tolerance
        int rays = 0;
        int passed = 0;  // of them: on its way it was farther below the surface than the tolerance
    };

    template <typename Look>
    double draw(const render::TiledSurface& surface, app::PagedPhoto* photo, const render::Camera& camera,
                const render::ViewSettings& settings, const Look& look) {
        const double begin = run_time_s() - read_cpu_s();
        look();
        renderer_.lay(photo ? photo->laid() : render::LaidPhoto{});
        renderer_.draw(surface, camera, settings, flown_size.x, flown_size.y);
        const std::vector<std::uint8_t> wait = renderer_.read_rgb(1, 1);
        return run_time_s() - read_cpu_s() - begin;
    }

    // Of the threads that read. Where a GPU draws, frames are measured by wall time, and it counts for
    // nothing.
    double read_cpu_s() {
        if (busy_cores() == 1) return 0;
        double seconds = paging_.read_cpu_s();
        for (app::PagedPhoto* photo : {paged_photo_.get(), loaded_photo_.get()})
            if (photo) seconds += photo->read_cpu_s();
        return seconds;
    }

    // distance_m: of the hit; infinite where the sky is seen.
    void check(const render::Camera& camera, glm::ivec2 pixel, float distance_m, double tolerance_px,
               Seen& seen) {
        const render::CameraRays rays = render::camera_rays(camera, flown_size.x, flown_size.y);
        const glm::dvec2 at(2 * (pixel.x + 0.5) / flown_size.x - 1, 1 - 2 * (pixel.y + 0.5) / flown_size.y);
        const glm::dvec3 way = glm::normalize(rays.middle + at.x * rays.right + at.y * rays.up);
        // How far from the pixel the surface is seen above or below a place of its ray.
        const auto off_px = [&](glm::dvec3 place, double ground_m) {
            const auto seen_at = render::place_in_picture(camera, rays, {place.x, place.y, ground_m});
            // Beside the eye it is as far off as can be.
            return seen_at ? glm::length(0.5 * (*seen_at - at) * glm::dvec2(flown_size))
                           : std::numeric_limits<double>::infinity();
        };
        bool passed = false;
        finest_.along(camera.eye, way, distance_m, [&](glm::dvec3 place, double ground_m) {
            passed = passed || (ground_m > place.z && off_px(place, ground_m) > tolerance_px);
        });
        ++seen.rays;
        seen.passed += passed ? 1 : 0;
        if (std::isinf(distance_m)) return;
        const glm::dvec3 hit = camera.eye + static_cast<double>(distance_m) * way;
        ++seen.hits;
        // On the terrain's sides there is no ground.
        const std::optional<double> ground_m = finest_.height_m(hit);
        seen.off += ground_m && off_px(hit, *ground_m) > tolerance_px ? 1 : 0;
    }

    const app::TiledTerrain& terrain_;
    const FlightRun& run_;
    FinestSurface finest_;
    render::TiledSurface paged_;
    render::TiledSurface loaded_;
    render::TileLoading loading_;
    render::TiledRenderer renderer_;
    std::unique_ptr<app::PagedPhoto> paged_photo_;
    std::unique_ptr<app::PagedPhoto> loaded_photo_;
    int late_ = 0;
    int off_ = 0;
    int passed_ = 0;
    bool over_ = false;
    render::TilePaging paging_;
};

}  // namespace

void bench_flight(const FlightRun& run) {
    io::limit_read_memory(static_cast<std::size_t>(run.host_mib) << 20);
    io::return_read_memory();
    const app::TiledTerrain terrain = app::open_tiled({run.file, {}}, app::on_terminal());
    const Grid& grid = terrain.tree.grid();
    Flight flight(terrain, run);
    const double extent_m = run.extent_m.value_or(std::min(grid.width_m(), grid.height_m()));
    const glm::dvec2 middle = run.middle_m.value_or(0.5 * glm::dvec2(grid.width_m(), grid.height_m()));
    fmt::print("{} x {} samples, {:.1f} of {} MiB of the device for tiles", grid.nx, grid.ny,
               mib(flight.tile_bytes()), run.gpu_mib);
    if (!run.photo.empty())
        fmt::print(", {:.1f} of {} MiB for those of '{}'", mib(flight.photo_bytes()), run.photo_mib,
                   run.photo);
    fmt::print("\n");
    if (mib(flight.tile_bytes()) > run.gpu_mib || mib(flight.photo_bytes()) > run.photo_mib)
        throw Error("tiles take more memory of the device than they may");
    flight.fly("ground", flight.way(middle, 0.004 * extent_m, 0.5 * extent_m, 0.25));
    flight.fly("high", flight.way(middle, 0.1 * extent_m, 0.6 * extent_m, 0.7));
    flight.check();
}

}  // namespace talus::bench
