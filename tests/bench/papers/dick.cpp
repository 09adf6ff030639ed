// Figures of Dick, Krüger & Westermann 2009.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "sim/error.h"
#include "tests/bench/papers/easel.h"
#include "tests/bench/papers/table.h"
#include "tests/bench/papers/tables.h"

namespace talus::bench {
namespace {

// Columns that a ray crosses from where it comes over the terrain and under its highest sample: the steps of
// a walk without a pyramid.
double columns_crossed(const Grid& grid, double highest_m, const render::Camera& camera, glm::dvec3 ray,
                       double distance_m) {
    double begin = 0;
    const glm::dvec2 eye(camera.eye);
    const glm::dvec2 size(grid.width_m(), grid.height_m());
    for (int axis = 0; axis < 2; ++axis) {
        if (ray[axis] == 0) continue;
        const double a = -eye[axis] / ray[axis];
        const double b = (size[axis] - eye[axis]) / ray[axis];
        begin = std::max(begin, std::min(a, b));
    }
    if (ray.z < 0) begin = std::max(begin, (highest_m - camera.eye.z) / ray.z);
    const double over = std::max(distance_m - begin, 0.0);
    return 1 + over * (std::abs(ray.x) / grid.dx + std::abs(ray.y) / grid.dy);
}

// A method that walks columns without beams, over the whole pyramid, or over its finest level alone: squares
// of two by two columns.
Entry columns_by(bool pyramid) {
    auto program = std::make_shared<gpu::Program>(
        std::vector<std::string>{"render/fullscreen.vert", "render/exact.frag"},
        std::vector<std::string>{"COLUMNS", "NO_BEAMS"});
    const auto draw = [program, pyramid](const render::Frame& frame) {
        frame.pyramid.bind(*program, frame.terrain);
        set_camera(*program, frame.terrain.grid(), frame.camera, frame.width, frame.height);
        if (!pyramid) program->set("top_level", 1);
        frame.hits.bind({0, 0, frame.width, frame.height});
        program->draw_fullscreen();
    };
    return {pyramid ? "pyramid" : "finest level", {draw, nullptr}};
}

}  // namespace

// Columns with the pyramid, and with its finest level alone, squares of two by two columns: time. Without any
// pyramid it would take longer.
void dick_pyramid(const PaperRun& run) {
    Table table("dick_pyramid", "terrain,pictures,pyramid_ms,finest_level_ms,finest_level_to_pyramid");
    for (const std::string& name : run.terrains) {
        const PaperTerrain terrain = paper_terrain(name);
        PaperEasel easel(terrain, small_picture, run.patch_pixels);
        const std::vector<Entry> entries = {columns_by(true), columns_by(false)};
        for (const bool walks : {false, true}) {
            std::vector<double> ms(2, 0);
            const auto cameras = walks ? paper_walk(terrain, 5) : paper_flight(terrain, 5);
            for (const render::Camera& camera : cameras) {
                // Each square is another step of the same way: the hits are the same bits.
                if (easel.distances(entries[0], camera) != easel.distances(entries[1], camera))
                    throw Error("dick_pyramid: by the finest level rays end elsewhere");
                const std::vector<double> times = easel.time_ms(entries, camera, 5);
                for (std::size_t i = 0; i < ms.size(); ++i)
                    ms[i] += times[i] / static_cast<double>(cameras.size());
            }
            table.row(fmt::format("{},{},{:.1f},{:.1f},{:.1f}", name, walks ? "walk" : "fly", ms[0], ms[1],
                                  ms[1] / ms[0]));
        }
    }
}

// Steps of rays onto columns, with the pyramid and without: of pixels that hit ground.
void dick_figure_6(const PaperRun& run) {
    Table table(
        "dick_figure_6",
        "terrain,pictures,mean_steps,half_within,nine_tenths_within,above_50_percent,mean_without_pyramid");
    constexpr glm::ivec2 size(1024, 768);
    for (const std::string& name : run.terrains) {
        const PaperTerrain terrain = paper_terrain(name);
        PaperEasel easel(terrain, size, run.patch_pixels);
        const double highest_m = *std::max_element(terrain.heights.begin(), terrain.heights.end());
        const Entry boxes = entry("boxes");
        const Entry steps = steps_of("boxes");
        for (const bool walks : {false, true}) {
            std::vector<double> found;
            double without = 0;
            for (const render::Camera& camera : walks ? paper_walk(terrain, 5) : paper_flight(terrain, 5)) {
                const std::vector<float> distances = easel.distances(boxes, camera);
                const std::vector<float> visited = easel.details(steps, camera);
                const render::CameraRays rays = camera_rays(camera, size.x, size.y);
                for (int y = 0; y < size.y; ++y)
                    for (int x = 0; x < size.x; ++x) {
                        const std::size_t i = static_cast<std::size_t>(y) * size.x + x;
                        if (std::isinf(distances[i])) continue;
                        found.push_back(visited[i]);
                        const glm::dvec3 ray =
                            glm::normalize(rays.middle + (2 * (x + 0.5) / size.x - 1) * rays.right +
                                           (2 * (y + 0.5) / size.y - 1) * rays.up);
                        without += columns_crossed(terrain.grid, highest_m, camera, ray, distances[i]);
                    }
            }
            const auto count = static_cast<double>(found.size());
            double sum = 0;
            for (const double visited : found) sum += visited;
            std::sort(found.begin(), found.end());
            const double beyond =
                static_cast<double>(found.end() - std::upper_bound(found.begin(), found.end(), 50.0));
            table.row(fmt::format("{},{},{:.1f},{},{},{:.2f},{:.0f}", name, walks ? "walk" : "fly",
                                  sum / count, found[found.size() / 2], found[found.size() * 9 / 10],
                                  100 * beyond / count, without / count));
        }
    }
}

}  // namespace talus::bench
