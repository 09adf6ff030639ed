#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <numeric>

#include "app/commands/commands.h"
#include "app/core/calibration.h"
#include "app/core/flight.h"
#include "app/core/outputs.h"
#include "app/core/report.h"
#include "render/hits_target.h"
#include "render/measure.h"
#include "render/methods/method.h"
#include "render/survey.h"
#include "render/view.h"
#include "sim/error.h"
#include "sim/gpu/timestamp.h"
#include "sim/io/atomic_file.h"

namespace talus::app {
namespace {

constexpr int timed_rounds = 5;

double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

// All that one method is measured on.
struct Subject {
    const Terrain& terrain;
    const render::Pyramid& pyramid;
    render::Measure& measure;
    const std::vector<render::NamedCamera>& cameras;
    glm::ivec2 size;
    double patch_pixels;
    double limit_px;
    const render::OwnNumbers& numbers;
};

// How many rays took so many steps; the last: that or more.
struct Steps {
    std::array<std::int64_t, 1024> rays{};

    void add(float walked) { ++rays[static_cast<std::size_t>(std::clamp(walked, 0.0F, 1023.0F))]; }
    double mean() const {
        double sum = 0;
        for (std::size_t n = 0; n < rays.size(); ++n)
            sum += static_cast<double>(n) * static_cast<double>(rays[n]);
        return sum / static_cast<double>(all());
    }
    double share_above(std::size_t limit) const {
        std::int64_t above = 0;
        for (std::size_t n = limit + 1; n < rays.size(); ++n) above += rays[n];
        return static_cast<double>(above) / static_cast<double>(all());
    }
    std::size_t p99() const {
        std::size_t limit = 0;
        while (share_above(limit) > 0.01) ++limit;
        return limit;
    }

  private:
    std::int64_t all() const { return std::accumulate(rays.begin(), rays.end(), std::int64_t{0}); }
};

// Median CPU time of a frame, ms, and what the device says of the last.
std::pair<double, double> time_frame(const render::Method& method, const render::Frame& frame,
                                     const render::HitsTarget& target) {
    gpu::Timestamp timer("frame");
    std::vector<double> seconds;
    std::optional<double> gpu_ms;
    for (int round = 0; round <= timed_rounds; ++round) {
        const double before = process_cpu_s();
        timer.begin();
        method(frame);
        timer.end();
        const std::vector<float> wait = target.read_distances(1, 1);
        if (round > 0) seconds.push_back(process_cpu_s() - before);
        gpu_ms = timer.milliseconds();
    }
    return {1000 * median(seconds), gpu_ms.value_or(0)};
}

nlohmann::ordered_json measure_method(const Subject& subject, const render::MethodEntry& entry,
                                      double tolerance_px) {
    const int width = subject.size.x;
    const int height = subject.size.y;
    const render::HitsTarget target(width, height);
    const render::Method plain = entry.make(render::Detail::none);
    const render::Method counting = entry.make(render::Detail::steps);
    const render::Method telling = entry.make(render::Detail::kind);
    nlohmann::ordered_json frames = nlohmann::ordered_json::array();
    render::PictureError all;
    double mean_square = 0;
    double mean_px = 0;
    double cpu_ms = 0;
    Steps steps;
    for (const render::NamedCamera& view : subject.cameras) {
        const render::Frame frame{
            subject.terrain, subject.pyramid,      view.camera,          width,   height,
            tolerance_px,    subject.patch_pixels, target.framebuffer(), nullptr, subject.numbers};
        const auto [frame_ms, gpu_ms] = time_frame(plain, frame, target);
        const render::PictureError error = subject.measure.compare(
            view.camera, width, height, target.read_distances(width, height), subject.limit_px);
        const render::MethodFigures figures = plain.figures();
        counting(frame);
        for (const float walked : target.read_details(width, height)) steps.add(walked);
        telling(frame);
        std::map<float, int> kinds;
        for (const float kind : target.read_details(width, height)) ++kinds[kind];
        nlohmann::ordered_json pixels;
        for (const auto& [kind, count] : kinds) pixels[fmt::format("{:g}", kind)] = count;
        frames.push_back({{"camera", view.name},
                          {"psnr_db", error.psnr_db},
                          {"mean_px", error.mean_px},
                          {"largest_px", error.largest_px},
                          {"beyond_limit", error.beyond},
                          {"pixels_hit", error.pixels_hit},
                          {"wrong_coverage", error.wrong_coverage},
                          {"silhouettes", error.silhouettes},
                          {"silhouettes_missed", error.silhouettes_missed},
                          {"cpu_ms", frame_ms},
                          {"gpu_ms", gpu_ms},
                          {"mesh_cells", figures.mesh_cells},
                          {"triangles", figures.triangles},
                          {"pixels_by_kind", pixels},
                          {"bytes", figures.bytes + subject.pyramid.bytes() + target.bytes()}});
        all.wrong_coverage += error.wrong_coverage;
        all.silhouettes += error.silhouettes;
        all.silhouettes_missed += error.silhouettes_missed;
        all.beyond += error.beyond;
        all.largest_px = std::max(all.largest_px, error.largest_px);
        mean_px += error.mean_px;
        mean_square += std::isinf(error.psnr_db) ? 0 : std::pow(10, -error.psnr_db / 10);
        cpu_ms += frame_ms;
    }
    const auto count = static_cast<double>(subject.cameras.size());
    return {{"method", entry.name},
            {"tolerance_px", tolerance_px},
            {"cpu_ms", cpu_ms / count},
            {"psnr_db", mean_square > 0 ? -10 * std::log10(mean_square / count) : HUGE_VAL},
            {"mean_px", mean_px / count},
            {"largest_px", all.largest_px},
            {"beyond_limit", all.beyond},
            {"wrong_coverage", all.wrong_coverage},
            {"silhouettes", all.silhouettes},
            {"silhouettes_missed", all.silhouettes_missed},
            {"steps_mean", steps.mean()},
            {"steps_p99", steps.p99()},
            {"steps_above_35", steps.share_above(35)},
            {"steps_above_85", steps.share_above(85)},
            {"frames", frames}};
}

}  // namespace

void compare(const CompareOptions& options) {
    std::vector<render::MethodEntry> entries;
    for (const std::string& name : options.methods) entries.push_back(render::method_named(name, "--method"));
    if (entries.empty()) entries = render::methods();
    if (options.size.x < 1 || options.size.y < 1 || options.size.x > 4096 || options.size.y > 4096)
        throw Error(fmt::format("--size {}x{} cannot be compared, each side must be 1 to 4096 pixels",
                                options.size.x, options.size.y));
    if (!options.report.empty()) check_folder(options.report);
    const gpu::Context context(options.gpu);
    say(gpu::describe(context.device()));
    const Scene scene = make_scene(options.scene);
    const Grid& grid = scene.document.state.grid;
    const std::vector<float> ground = scene.document.state.ground();
    std::vector<render::NamedCamera> cameras;
    if (options.keys.empty()) {
        cameras = render::survey(grid, ground);
    } else {
        const auto keys = read_keys(options.keys, scene.view.number("camera.fov_deg"));
        for (const render::Camera& camera : fly_along(keys, options.frames))
            cameras.push_back({fmt::format("frame {}", cameras.size()), camera});
    }
    Terrain terrain(scene.document.state);
    render::Pyramid pyramid(terrain);
    pyramid.refresh(terrain);
    render::Measure measure(grid, ground);
    const render::ViewSettings settings = render::view_settings(scene.view, scene.simulation);
    const Subject subject{terrain,          pyramid,         measure,
                          cameras,          options.size,    patch_pixels(context.device()),
                          options.limit_px, settings.numbers};
    nlohmann::ordered_json report;
    report["device"] = gpu::describe(context.device());
    report["terrain"] = scene.title;
    report["samples"] = {grid.nx, grid.ny};
    report["size"] = {options.size.x, options.size.y};
    report["limit_px"] = options.limit_px;
    report["results"] = nlohmann::ordered_json::array();
    if (!options.json)
        fmt::print("{:<8} {:>9} {:>8} {:>8} {:>9} {:>10} {:>7} {:>9} {:>11} {:>6} {:>4}\n", "method",
                   "tolerance", "CPU ms", "PSNR dB", "mean px", "largest px", "beyond", "coverage",
                   "silhouettes", "steps", "p99");
    for (const render::MethodEntry& entry : entries) {
        std::vector<double> tolerances = {0};
        if (entry.heeds_tolerance) tolerances = options.tolerances_px;
        for (const double tolerance : tolerances) {
            const nlohmann::ordered_json r = measure_method(subject, entry, tolerance);
            report["results"].push_back(r);
            if (options.json) continue;
            fmt::print("{:<8} {:>9} {:>8.2f} {:>8.1f} {:>9.5f} {:>10.4f} {:>7} {:>9} {:>11} {:>6.1f} {:>4}\n",
                       entry.name, entry.heeds_tolerance ? fmt::format("{:g}", tolerance) : "-",
                       r["cpu_ms"].get<double>(), r["psnr_db"].get<double>(), r["mean_px"].get<double>(),
                       r["largest_px"].get<double>(), r["beyond_limit"].get<int>(),
                       r["wrong_coverage"].get<int>(),
                       fmt::format("{}/{}", r["silhouettes_missed"].get<int>(), r["silhouettes"].get<int>()),
                       r["steps_mean"].get<double>(), r["steps_p99"].get<int>());
        }
    }
    if (!options.report.empty()) io::write_atomically(options.report, report.dump(2) + "\n");
    if (options.json) fmt::print("{}\n", report.dump(2));
}

}  // namespace talus::app
