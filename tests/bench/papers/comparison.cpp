// Every method over the same pictures: time and errors.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "render/measure.h"
#include "render/survey.h"
#include "tests/bench/measure.h"
#include "tests/bench/papers/easel.h"
#include "tests/bench/papers/psnr.h"
#include "tests/bench/papers/table.h"
#include "tests/bench/papers/tables.h"

namespace talus::bench {
namespace {

// Every method over cameras: mean time, and errors against the bilinear surface and against the full mesh.
void compare(Table& table, const PaperTerrain& terrain, const std::string& on, PaperEasel& easel,
             render::Measure& measure, std::vector<Entry> entries, const std::vector<render::Camera>& cameras,
             int rounds, const std::string& only) {
    std::erase_if(entries, [&](const Entry& one) { return !one.name.starts_with(only); });
    if (entries.empty()) return;
    const Entry mesh = entry("mesh");
    std::vector<double> ms(entries.size(), 0);
    std::vector<double> worst_ms(entries.size(), 0);
    std::vector<Psnr> to_bilinear(entries.size(), Psnr(terrain));
    std::vector<Psnr> to_mesh(entries.size(), Psnr(terrain));
    std::vector<long> beyond(entries.size(), 0);
    std::vector<long> coverage(entries.size(), 0);
    long hit = 0;
    for (const render::Camera& camera : cameras) {
        const std::vector<double> times = easel.time_ms(entries, camera, rounds);
        const std::vector<double> truth = measure.reference(camera, small_picture.x, small_picture.y);
        const std::vector<float> by_mesh = easel.distances(mesh, camera);
        for (std::size_t i = 0; i < entries.size(); ++i) {
            const std::vector<float> shown = easel.distances(entries[i], camera);
            const render::PictureError error =
                measure.compare(camera, small_picture.x, small_picture.y, shown, 0.5);
            ms[i] += times[i] / static_cast<double>(cameras.size());
            worst_ms[i] = std::max(worst_ms[i], times[i]);
            to_bilinear[i].add(shown, truth);
            to_mesh[i].add(shown, by_mesh);
            beyond[i] += error.beyond;
            coverage[i] += error.wrong_coverage;
            hit += i == 0 ? error.pixels_hit : 0;
        }
    }
    const auto share = [&](long pixels) {
        return 100.0 * static_cast<double>(pixels) / static_cast<double>(hit);
    };
    for (std::size_t i = 0; i < entries.size(); ++i)
        table.row(fmt::format("{},{},{},{:.2f},{:.2f},{:.1f},{:.1f},{:.4f},{:.4f}", terrain.name, on,
                              entries[i].name, ms[i], worst_ms[i], to_bilinear[i].db(), to_mesh[i].db(),
                              share(coverage[i]), share(beyond[i])));
}

constexpr const char* compared =
    "terrain,cameras,method,ms,worst_ms,psnr_db,psnr_to_mesh_db,wrong_coverage_percent,beyond_half_pixel_"
    "percent";

}  // namespace

// Ammann 2010, figure 7: error against time over a flight, for k and T, beside both clipmaps and the others.
void flight(const PaperRun& run) {
    Table table("flight", compared);
    for (const std::string& name : run.terrains) {
        const PaperTerrain terrain = paper_terrain(name);
        PaperEasel easel(terrain, small_picture, run.patch_pixels);
        render::Measure measure(terrain.grid, terrain.heights);
        std::vector<Entry> entries = {entry("hybrid"),
                                      entry("exact"),
                                      entry("boxes"),
                                      entry("relief"),
                                      clipmap(3, 11, "clipmap n 511"),
                                      clipmap(1, 13, "clipmap n 127")};
        for (const double k : {0.5, 1.0, 1.5, 2.0})
            for (const double t : {1.0, 100.0}) entries.push_back(ammann(k, t));
        const std::vector<render::Camera> cameras = paper_flight(terrain, 8);
        compare(table, terrain, "flight", easel, measure, entries, cameras, 3, run.method);
        // These take seconds a frame.
        compare(table, terrain, "flight", easel, measure, {entry("mesh"), entry("uniform")}, cameras, 1,
                run.method);
    }
}

// The same over the survey's twelve cameras.
void survey(const PaperRun& run) {
    Table table("survey", compared);
    for (const std::string& name : run.terrains) {
        const PaperTerrain terrain = paper_terrain(name);
        PaperEasel easel(terrain, small_picture, run.patch_pixels);
        render::Measure measure(terrain.grid, terrain.heights);
        std::vector<render::Camera> cameras;
        for (const render::NamedCamera& view : render::survey(terrain.grid, terrain.heights))
            cameras.push_back(view.camera);
        compare(table, terrain, "survey", easel, measure,
                {entry("hybrid"), entry("exact"), entry("boxes"), entry("relief"), ammann(1.3, 70),
                 clipmap(3, 11, "clipmap n 511"), clipmap(1, 13, "clipmap n 127")},
                cameras, 3, run.method);
        compare(table, terrain, "survey", easel, measure, {entry("mesh"), entry("uniform")}, cameras, 1,
                run.method);
    }
}

// hybrid against exact, camera by camera: both are exact to the tolerance, and hybrid should choose the
// cheaper.
void cameras(const PaperRun& run) {
    Table table("cameras", "terrain,camera,hybrid_ms,exact_ms,hybrid_to_exact");
    const std::vector<Entry> entries = {entry("hybrid"), entry("exact")};
    for (const std::string& name : run.terrains) {
        const PaperTerrain terrain = paper_terrain(name);
        PaperEasel easel(terrain, {1280, 720}, run.patch_pixels);
        std::vector<render::NamedCamera> views = render::survey(terrain.grid, terrain.heights);
        for (const render::Camera& camera : paper_flight(terrain, 8))
            views.push_back({fmt::format("flight {}", views.size() - 11), camera});
        for (const render::NamedCamera& view : views) {
            const std::vector<double> ms = easel.time_ms(entries, view.camera, 15);
            table.row(
                fmt::format("{},{},{:.1f},{:.1f},{:.3f}", name, view.name, ms[0], ms[1], ms[0] / ms[1]));
        }
    }
}

}  // namespace talus::bench
