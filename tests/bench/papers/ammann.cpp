// Tables and figures of Ammann, Génevaux & Dischler 2010.
#include <fmt/format.h>
#include <fmt/os.h>

#include <algorithm>
#include <cmath>

#include "render/methods/method.h"
#include "tests/bench/papers/easel.h"
#include "tests/bench/papers/picture.h"
#include "tests/bench/papers/psnr.h"
#include "tests/bench/papers/table.h"
#include "tests/bench/papers/tables.h"

namespace talus::bench {
namespace {

constexpr double never_px = 1e9;

// At the terrain's middle, halfway up its relief, so many degrees over the horizon; distance: in widths of
// the terrain.
render::Camera view_from(const PaperTerrain& terrain, double angle_deg, double distance) {
    const auto [low, high] = std::minmax_element(terrain.heights.begin(), terrain.heights.end());
    const glm::dvec3 middle(0.5 * terrain.grid.width_m(), 0.5 * terrain.grid.height_m(),
                            0.5 * (*low + *high));
    const double angle = angle_deg * 3.14159265358979 / 180;
    const glm::dvec3 way(0.6 * std::cos(angle), 0.8 * std::cos(angle), std::sin(angle));
    return {middle + distance * terrain.grid.width_m() * way, middle, 45};
}

// Of the pixels that rays drew: how many samples the level of precision takes that drew them, at most, with
// cells of 75 samples.
double mean_samples_shown(PaperEasel& easel, const render::Camera& camera,
                          const std::vector<glm::ivec2>& steps) {
    const render::OwnNumbers numbers = {{"render.ammann_cell_samples", 75},
                                        {"render.ammann_levels", static_cast<double>(steps.size())}};
    const Entry kinds = {"kinds", render::method_named("ammann").make(render::Detail::kind), numbers};
    // The mesh, then a kind a level.
    const std::vector<render::PixelKind> known = render::ammann_kinds(numbers);
    double pixels = 0;
    double samples = 0;
    for (const float shown : easel.details(kinds, camera))
        for (std::size_t level = 0; level < steps.size(); ++level)
            if (std::abs(shown - known[1 + level].kind) < 1e-3) {
                pixels += 1;
                samples += steps[level].x;
            }
    return samples / pixels;
}

struct Box {
    glm::dvec3 low;  // world metres
    glm::dvec3 high;
};

// Around cells of so many samples in a row, each with the first sample of the next.
std::vector<Box> boxes_of(const PaperTerrain& terrain, int size) {
    const Grid& grid = terrain.grid;
    std::vector<Box> boxes;
    for (int row = 0; row < grid.ny - 1; row += size)
        for (int column = 0; column < grid.nx - 1; column += size) {
            const glm::ivec2 last =
                glm::min(glm::ivec2(column, row) + size, glm::ivec2(grid.nx, grid.ny) - 1);
            float low = terrain.heights[static_cast<std::size_t>(row) * grid.nx + column];
            float high = low;
            for (int y = row; y <= last.y; ++y)
                for (int x = column; x <= last.x; ++x) {
                    const float height = terrain.heights[static_cast<std::size_t>(y) * grid.nx + x];
                    low = std::min(low, height);
                    high = std::max(high, height);
                }
            boxes.push_back({{column * grid.dx, (grid.ny - 1 - last.y) * grid.dy, low},
                             {last.x * grid.dx, (grid.ny - 1 - row) * grid.dy, high}});
        }
    return boxes;
}

bool crosses(const Box& box, glm::dvec3 eye, glm::dvec3 way) {
    const glm::dvec3 to_low = (box.low - eye) / way;
    const glm::dvec3 to_high = (box.high - eye) / way;
    const glm::dvec3 enter = glm::min(to_low, to_high);
    const glm::dvec3 leave = glm::max(to_low, to_high);
    return std::max({enter.x, enter.y, enter.z, 0.0}) <= std::min({leave.x, leave.y, leave.z});
}

}  // namespace

// Ammann 2010, table 1: rays alone, of their lowest and highest precision, and the full mesh.
void ammann_table_1(const PaperRun& run) {
    Table table("ammann_table_1", "terrain,low_precision_ms,high_precision_ms,full_mesh_ms");
    for (const std::string& name : run.terrains) {
        const PaperTerrain terrain = paper_terrain(name);
        PaperEasel easel(terrain, {1024, 768}, run.patch_pixels);
        const std::vector<Entry> entries = {
            {"low", render::make_ammann_of({{5, 2}}, false), {{"render.ammann_mesh_from_px2", never_px}}},
            {"high", render::make_ammann_of({{64, 25}}, false), {{"render.ammann_mesh_from_px2", never_px}}},
            entry("mesh")};
        const std::vector<double> ms = easel.time_ms(entries, grazing_view(terrain), 5);
        table.row(fmt::format("{},{:.1f},{:.1f},{:.1f}", name, ms[0], ms[1], ms[2]));
    }
}

// Ammann 2010, table 2: numbers of levels of precision, cells of 75 samples; and what it costs to read the
// choices back. Two columns are a profile of the first: the time where all levels take the same steps, so
// that only the number of programs and of draws differs; and the mean of the samples of what the pixels show.
void ammann_table_2(const PaperRun& run) {
    Table table("ammann_table_2", "terrain,levels,ms,with_read_back_ms,same_steps_ms,mean_samples");
    const PaperTerrain terrain = paper_terrain("mountains");
    PaperEasel easel(terrain, {1024, 768}, run.patch_pixels);
    const render::Camera camera = paper_flight(terrain, 5)[1];
    const std::vector<int> numbers = {2, 4, 6, 8, 10};
    std::vector<Entry> entries;
    std::vector<double> mean_samples;
    const auto enter = [&](const std::vector<glm::ivec2>& steps, bool reads_back) {
        entries.push_back({fmt::format("{} levels", steps.size()),
                           render::make_ammann_of(steps, reads_back),
                           {{"render.ammann_cell_samples", 75}}});
    };
    for (const int levels : numbers) {
        // From 64 samples to 6 and from 50 halvings to 5, by equal ratios.
        std::vector<glm::ivec2> steps;
        for (int level = 0; level < levels; ++level) {
            const double share = static_cast<double>(level) / (levels - 1);
            steps.emplace_back(std::lround(64 * std::pow(6.0 / 64, share)),
                               std::lround(50 * std::pow(5.0 / 50, share)));
        }
        enter(steps, false);
        enter(steps, true);
        enter(std::vector<glm::ivec2>(steps.size(), {20, 16}), false);
        mean_samples.push_back(mean_samples_shown(easel, camera, steps));
    }
    const std::vector<double> ms = easel.time_ms(entries, camera, 9);
    for (std::size_t i = 0; i < numbers.size(); ++i)
        table.row(fmt::format("{},{},{:.2f},{:.2f},{:.2f},{:.1f}", terrain.name, numbers[i], ms[3 * i],
                              ms[3 * i + 1], ms[3 * i + 2], mean_samples[i]));
}

// Ammann 2010, figure 4: where rays of low precision are wrong along the ground; a file of its own holds the
// picture.
void ammann_figure_4(const PaperRun& run) {
    Table table("ammann_figure_4",
                "terrain,psnr_db,below_1_percent,below_5_percent,below_10_percent,wrong_coverage_percent");
    const PaperTerrain terrain = paper_terrain("spectrogram");
    PaperEasel easel(terrain, small_picture, run.patch_pixels);
    const Entry low = {
        "low", render::make_ammann_of({{5, 2}}, false), {{"render.ammann_mesh_from_px2", never_px}}};
    const render::Camera camera = view_from(terrain, 10, 0.6);
    const std::vector<float> shown = easel.distances(low, camera);
    const std::vector<float> by_mesh = easel.distances(entry("mesh"), camera);
    Psnr psnr(terrain);
    psnr.add(shown, by_mesh);
    fmt::ostream map = fmt::output_file("out/papers/ammann_figure_4_map.csv");
    map.print("x,y,error_percent\n");
    std::vector<double> errors;
    double ground = 0;
    double wrong_coverage = 0;
    for (std::size_t i = 0; i < shown.size(); ++i) {
        ground += std::isinf(by_mesh[i]) ? 0 : 1;
        if (std::isinf(shown[i]) != std::isinf(by_mesh[i])) ++wrong_coverage;
        const bool both = !std::isinf(shown[i]) && !std::isinf(by_mesh[i]);
        const double percent = both ? 100 * std::abs(shown[i] - by_mesh[i]) / terrain.grid.width_m() : -1;
        if (both) errors.push_back(percent);
        map.print("{},{},{:.4f}\n", i % small_picture.x, i / small_picture.x, percent);
    }
    const auto below = [&](double percent) {
        return 100.0 *
               static_cast<double>(
                   std::count_if(errors.begin(), errors.end(), [&](double one) { return one < percent; })) /
               static_cast<double>(errors.size());
    };
    table.row(fmt::format("{},{:.2f},{:.1f},{:.1f},{:.1f},{:.2f}", terrain.name, psnr.db(), below(1),
                          below(5), below(10), 100 * wrong_coverage / ground));
}

// Ammann 2010, figure 6: sizes of cells.
void ammann_figure_6(const PaperRun& run) {
    Table table("ammann_figure_6", "terrain,cell_samples,ms");
    for (const std::string& name : run.terrains) {
        const PaperTerrain terrain = paper_terrain(name);
        PaperEasel easel(terrain, {1024, 768}, run.patch_pixels);
        const std::vector<int> sizes = {16, 24, 32, 50, 64, 96, 128, 192, 256, 512};
        const std::vector<render::Camera> cameras = paper_flight(terrain, 4);
        for (const int size : sizes) {
            const std::vector<Entry> entries = {entry("ammann", {{"render.ammann_cell_samples", size}})};
            double ms = 0;
            for (const render::Camera& camera : cameras) ms += easel.time_ms(entries, camera, 3).front();
            table.row(fmt::format("{},{},{:.2f}", name, size, ms / static_cast<double>(cameras.size())));
        }
    }
}

// A profile of figure 6: how many cells' boxes a pixel's ray crosses, near or far, over the same pictures.
// Where a fragment is not rejected early, each of them is sampled.
void ammann_boxes(const PaperRun& run) {
    Table table("ammann_boxes", "terrain,cell_samples,boxes_per_ray");
    for (const std::string& name : run.terrains) {
        const PaperTerrain terrain = paper_terrain(name);
        const std::vector<render::Camera> cameras = paper_flight(terrain, 4);
        for (const int size : {16, 32, 64, 128, 256, 512}) {
            const std::vector<Box> boxes = boxes_of(terrain, size);
            long rays = 0;
            long crossed = 0;
            for (const render::Camera& camera : cameras) {
                const render::CameraRays picture = render::camera_rays(camera, 1024, 768);
                for (int y = -11; y <= 11; ++y)
                    for (int x = -15; x <= 15; ++x) {
                        const glm::dvec3 way =
                            picture.middle + x / 16.0 * picture.right + y / 12.0 * picture.up;
                        ++rays;
                        for (const Box& box : boxes) crossed += crosses(box, camera.eye, way) ? 1 : 0;
                    }
            }
            table.row(fmt::format("{},{},{:.1f}", name, size,
                                  static_cast<double>(crossed) / static_cast<double>(rays)));
        }
    }
}

// Ammann 2010, figure 5: error of both precisions by the angle and the distance of the view.
void ammann_figure_5(const PaperRun& run) {
    Table table("ammann_figure_5", "terrain,angle_deg,distance,low_precision_db,high_precision_db");
    for (const std::string& name : run.terrains) {
        const PaperTerrain terrain = paper_terrain(name);
        PaperEasel easel(terrain, small_picture, run.patch_pixels);
        const Entry mesh = entry("mesh");
        const std::vector<Entry> entries = {
            {"low", render::make_ammann_of({{5, 2}}, false), {{"render.ammann_mesh_from_px2", never_px}}},
            {"high", render::make_ammann_of({{64, 25}}, false), {{"render.ammann_mesh_from_px2", never_px}}}};
        for (const double distance : {0.6, 1.0, 1.5})
            for (const double angle_deg : {10, 20, 30, 45, 60, 75, 89}) {
                const render::Camera camera = view_from(terrain, angle_deg, distance);
                std::vector<Psnr> psnr(2, Psnr(terrain));
                const std::vector<float> by_mesh = easel.distances(mesh, camera);
                for (std::size_t i = 0; i < 2; ++i) psnr[i].add(easel.distances(entries[i], camera), by_mesh);
                table.row(fmt::format("{},{},{},{:.1f},{:.1f}", name, angle_deg, distance, psnr[0].db(),
                                      psnr[1].db()));
            }
    }
}

// Ammann 2010, figure 9: the same part of a picture by several methods, each a file of its own, and how far
// off its distances are.
void ammann_figure_9(const PaperRun& run) {
    Table table("ammann_figure_9", "picture,psnr_to_mesh_db,wrong_coverage_pixels,pixels");
    const PaperTerrain terrain = paper_terrain("high_amplitude");
    constexpr glm::ivec2 size(256, 192);
    PaperEasel easel(terrain, size, run.patch_pixels);
    const Terrain coloured(bedrock_terrain(terrain.grid, terrain.heights));
    render::Renderer renderer(coloured, run.patch_pixels);
    // A quarter of the width and height of 1024 x 768, about its crests.
    render::Camera camera = view_from(terrain, 8, 0.6);
    camera.window_share = {0.25, 0.25};
    camera.window_middle = {0.1, 0.15};
    const std::vector<float> by_mesh = easel.distances(entry("mesh"), camera);
    for (const Entry& one : {entry("mesh"), ammann(1, 100), ammann(1.5, 100), clipmap(3, 11, "clipmap n 511"),
                             clipmap(1, 13, "clipmap n 127"), entry("hybrid")}) {
        render::ViewSettings settings;
        settings.method = one.name.substr(0, one.name.find(' '));
        settings.view = "hillshade";
        settings.numbers = one.numbers;
        write_picture(renderer, coloured, camera, settings, size, "ammann_figure_9 " + one.name);
        const std::vector<float> shown = easel.distances(one, camera);
        Psnr psnr(terrain);
        psnr.add(shown, by_mesh);
        int wrong = 0;
        for (std::size_t i = 0; i < shown.size(); ++i)
            wrong += std::isinf(shown[i]) != std::isinf(by_mesh[i]) ? 1 : 0;
        table.row(fmt::format("{},{:.1f},{},{}", one.name, psnr.db(), wrong, shown.size()));
    }
}

}  // namespace talus::bench
