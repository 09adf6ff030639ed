// Tables and figures of Park & Oh 2009.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "render/measure.h"
#include "tests/bench/measure.h"
#include "tests/bench/papers/easel.h"
#include "tests/bench/papers/picture.h"
#include "tests/bench/papers/psnr.h"
#include "tests/bench/papers/table.h"
#include "tests/bench/papers/tables.h"

namespace talus::bench {
namespace {

double mean_ms(PaperEasel& easel, const Entry& entry, const std::vector<render::Camera>& cameras) {
    double ms = 0;
    for (const render::Camera& camera : cameras) ms += easel.time_ms({entry}, camera, 3).front();
    return ms / static_cast<double>(cameras.size());
}

}  // namespace

// A frame of rays, of the full mesh and of a mesh with levels of detail, at growing numbers of samples over
// the same ground; and the pyramid from nothing.
void park_oh_table_1(const PaperRun& run) {
    Table table("park_oh_table_1",
                "samples,pyramid_ms,exact_fly_ms,exact_walk_ms,mesh_fly_ms,clipmap_fly_ms");
    for (const int side : {256, 512, 1024, 2048, 4096, 8192}) {
        const PaperTerrain terrain = paper_terrain_of(side);
        PaperEasel easel(terrain, {1024, 768}, run.patch_pixels);
        const Entry exact = entry("exact");
        const auto cameras = paper_flight(terrain, 4);
        const double pyramid_s = interleave({{"pyramid",
                                              [&] {
                                                  easel.terrain().tiles.mark_all();
                                                  easel.pyramid().refresh(easel.terrain());
                                                  easel.pyramid().highest.read_all<float>(0);
                                              }}},
                                            3)
                                     .front();
        table.row(fmt::format("{},{:.1f},{:.1f},{:.1f},{:.1f},{:.1f}", side, 1e3 * pyramid_s,
                              mean_ms(easel, exact, cameras), mean_ms(easel, exact, paper_walk(terrain, 4)),
                              mean_ms(easel, entry("mesh"), cameras),
                              mean_ms(easel, clipmap(3, 11, "clipmap n 511"), cameras)));
    }
}

// Columns against bilinear patches, from the air and on the ground.
void park_oh_figure_11(const PaperRun& run) {
    Table table("park_oh_figure_11",
                "terrain,pictures,columns_ms,patches_ms,columns_psnr_db,columns_beyond_half_pixel_percent");
    for (const std::string& name : run.terrains) {
        const PaperTerrain terrain = paper_terrain(name);
        PaperEasel easel(terrain, small_picture, run.patch_pixels);
        render::Measure measure(terrain.grid, terrain.heights);
        const std::vector<Entry> entries = {entry("boxes"), entry("exact")};
        for (const bool walks : {false, true}) {
            double columns_ms = 0;
            double patches_ms = 0;
            long hit = 0;
            long beyond = 0;
            Psnr psnr(terrain);
            const auto cameras = walks ? paper_walk(terrain, 5) : paper_flight(terrain, 5);
            for (const render::Camera& camera : cameras) {
                const std::vector<double> ms = easel.time_ms(entries, camera, 5);
                columns_ms += ms[0] / static_cast<double>(cameras.size());
                patches_ms += ms[1] / static_cast<double>(cameras.size());
                const std::vector<float> shown = easel.distances(entries[0], camera);
                psnr.add(shown, measure.reference(camera, small_picture.x, small_picture.y));
                const render::PictureError error =
                    measure.compare(camera, small_picture.x, small_picture.y, shown, 0.5);
                hit += error.pixels_hit;
                beyond += error.beyond;
            }
            table.row(fmt::format("{},{},{:.1f},{:.1f},{:.1f},{:.1f}", name, walks ? "walk" : "fly",
                                  columns_ms, patches_ms, psnr.db(),
                                  100.0 * static_cast<double>(beyond) / static_cast<double>(hit)));
        }
    }
}

// How many cells and patches rays visit that hit the ground.
void park_oh_figure_13(const PaperRun& run) {
    Table table("park_oh_figure_13",
                "terrain,pictures,within_16_percent,within_35_percent,above_80_percent,above_85_percent,"
                "mean,most");
    for (const std::string& name : run.terrains) {
        const PaperTerrain terrain = paper_terrain(name);
        PaperEasel easel(terrain, {1024, 768}, run.patch_pixels);
        const Entry exact = entry("exact");
        const Entry steps = steps_of("exact");
        render::Renderer renderer(easel.terrain(), run.patch_pixels);
        render::ViewSettings settings;
        settings.method = "exact";
        settings.view = "steps";
        for (const bool walks : {false, true}) {
            write_picture(renderer, easel.terrain(),
                          (walks ? paper_walk(terrain, 5) : paper_flight(terrain, 5))[1], settings,
                          small_picture,
                          fmt::format("park_oh_figure_13 {} {}", name, walks ? "walk" : "fly"));
            std::vector<double> found;
            for (const render::Camera& camera : walks ? paper_walk(terrain, 5) : paper_flight(terrain, 5)) {
                const std::vector<float> distances = easel.distances(exact, camera);
                const std::vector<float> visited = easel.details(steps, camera);
                for (std::size_t i = 0; i < visited.size(); ++i)
                    if (!std::isinf(distances[i])) found.push_back(visited[i]);
            }
            const auto share = [&](auto counts) {
                return 100.0 * static_cast<double>(std::count_if(found.begin(), found.end(), counts)) /
                       static_cast<double>(found.size());
            };
            double sum = 0;
            for (const double visited : found) sum += visited;
            table.row(fmt::format(
                "{},{},{:.1f},{:.1f},{:.2f},{:.2f},{:.1f},{}", name, walks ? "walk" : "fly",
                share([](double n) { return n <= 16; }), share([](double n) { return n <= 35; }),
                share([](double n) { return n > 80; }), share([](double n) { return n > 85; }),
                sum / static_cast<double>(found.size()), *std::max_element(found.begin(), found.end())));
        }
    }
}

}  // namespace talus::bench
