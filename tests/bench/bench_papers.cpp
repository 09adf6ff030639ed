// The tables and figures of the papers that Talus stands on, made again: each a file of out/papers, from
// which tests/bench/plot_papers.sh draws docs/papers. docs/papers.md says what came out.
#include <fmt/format.h>
#include <fmt/os.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>

#include "render/hits_target.h"
#include "render/measure.h"
#include "render/methods/method.h"
#include "render/survey.h"
#include "sim/error.h"
#include "tests/bench/measure.h"
#include "tests/bench/paper_terrains.h"

namespace talus::bench {
namespace {

// A method with its parameters, and what tables call it.
struct Entry {
    std::string name;
    render::Method method;
    render::OwnNumbers numbers = {};
};

Entry entry(const std::string& method, const render::OwnNumbers& numbers = {}, const std::string& name = "") {
    return {name.empty() ? method : name, render::method_named(method).make(render::Detail::none), numbers};
}

Entry ammann(double k, double t) {
    return entry("ammann", {{"render.ammann_range", k}, {"render.ammann_mesh_from_px2", t}},
                 fmt::format("ammann k {:g} T {:g}", k, t));
}

Entry clipmap(int choice, int levels, const std::string& name) {
    return entry("clipmap", {{"render.clipmap_samples", choice}, {"render.clipmap_levels", levels}}, name);
}

// A table as a file of values between commas, and on the terminal.
class Table {
  public:
    Table(const std::string& name, const std::string& columns)
        : file_(fmt::output_file("out/papers/" + name + ".csv")) {
        fmt::print("\n{}\n{}\n", name, columns);
        file_.print("{}\n", columns);
    }
    void row(const std::string& line) {
        fmt::print("{}\n", line);
        file_.print("{}\n", line);
        file_.flush();
    }

  private:
    fmt::ostream file_;
};

// A terrain on the device, at a size of picture.
class Easel {
  public:
    Easel(const PaperTerrain& terrain, glm::ivec2 size, double patch_pixels)
        : terrain_(bedrock_terrain(terrain.grid, terrain.heights)),
          pyramid_(terrain_),
          size_(size),
          patch_pixels_(patch_pixels),
          target_(size.x, size.y) {
        pyramid_.refresh(terrain_);
    }

    void draw(const Entry& entry, const render::Camera& camera) {
        entry.method({terrain_, pyramid_, camera, size_.x, size_.y, 0.5, patch_pixels_, target_.framebuffer(),
                      nullptr, entry.numbers});
        const std::vector<float> wait = target_.read_distances(1, 1);
    }
    std::vector<float> distances(const Entry& entry, const render::Camera& camera) {
        draw(entry, camera);
        return target_.read_distances(size_.x, size_.y);
    }
    // Median milliseconds of each, turn by turn.
    std::vector<double> time_ms(const std::vector<Entry>& entries, const render::Camera& camera, int rounds) {
        std::vector<Contestant> contestants;
        contestants.reserve(entries.size());
        for (const Entry& one : entries)
            contestants.push_back({one.name, [this, &one, &camera] { draw(one, camera); }});
        std::vector<double> times = interleave(contestants, rounds);
        for (double& time : times) time *= 1e3;
        return times;
    }

  private:
    Terrain terrain_;
    render::Pyramid pyramid_;
    glm::ivec2 size_;
    double patch_pixels_;
    render::HitsTarget target_;
};

// Mean squares of distances over many pictures, as decibels (Ammann 2010, section 4.1). R: the terrain's
// diagonal. Pixels where one of both shows the sky have no distance: they count as wrong coverage instead.
class Psnr {
  public:
    explicit Psnr(const PaperTerrain& terrain) {
        const auto [low, high] = std::minmax_element(terrain.heights.begin(), terrain.heights.end());
        diagonal_m_ = std::hypot(terrain.grid.width_m(), terrain.grid.height_m(), *high - *low);
    }
    template <typename Real>
    void add(const std::vector<float>& shown, const std::vector<Real>& reference) {
        for (std::size_t i = 0; i < shown.size(); ++i) {
            if (std::isinf(reference[i]) || std::isinf(shown[i])) continue;
            sum_ += (shown[i] - reference[i]) * (shown[i] - reference[i]);
            ++count_;
        }
    }
    double db() const { return sum_ > 0 ? 10 * std::log10(diagonal_m_ * diagonal_m_ * count_ / sum_) : 999; }

  private:
    double diagonal_m_;
    double sum_ = 0;
    double count_ = 0;
};

constexpr glm::ivec2 small_picture(480, 270);

// Every method over cameras: mean time, and errors against the bilinear surface and against the full mesh.
void compare(Table& table, const PaperTerrain& terrain, const std::string& on, Easel& easel,
             render::Measure& measure, const std::vector<Entry>& entries,
             const std::vector<render::Camera>& cameras, int rounds) {
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

// Ammann 2010, figure 7: error against time over a flight, for k and T, beside both clipmaps and the others.
void flights(double patch_pixels) {
    Table table("flight", compared);
    for (const std::string& name : paper_terrain_names()) {
        const PaperTerrain terrain = paper_terrain(name);
        Easel easel(terrain, small_picture, patch_pixels);
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
        compare(table, terrain, "flight", easel, measure, entries, cameras, 3);
        // These take seconds a frame.
        compare(table, terrain, "flight", easel, measure, {entry("mesh"), entry("uniform")}, cameras, 1);
    }
}

// The same over the survey's twelve cameras.
void surveys(double patch_pixels) {
    Table table("survey", compared);
    for (const std::string& name : paper_terrain_names()) {
        const PaperTerrain terrain = paper_terrain(name);
        Easel easel(terrain, small_picture, patch_pixels);
        render::Measure measure(terrain.grid, terrain.heights);
        std::vector<render::Camera> cameras;
        for (const render::NamedCamera& view : render::survey(terrain.grid, terrain.heights))
            cameras.push_back(view.camera);
        compare(table, terrain, "survey", easel, measure,
                {entry("hybrid"), entry("exact"), entry("boxes"), entry("relief"), ammann(1.3, 70),
                 clipmap(3, 11, "clipmap n 511"), clipmap(1, 13, "clipmap n 127")},
                cameras, 3);
        compare(table, terrain, "survey", easel, measure, {entry("mesh"), entry("uniform")}, cameras, 1);
    }
}

constexpr double never_px = 1e9;

// Ammann 2010, table 1: rays alone, of their lowest and highest precision, and the full mesh.
void ammann_table_1(double patch_pixels) {
    Table table("ammann_table_1", "terrain,low_precision_ms,high_precision_ms,full_mesh_ms");
    for (const std::string& name : paper_terrain_names()) {
        const PaperTerrain terrain = paper_terrain(name);
        Easel easel(terrain, {1024, 768}, patch_pixels);
        const std::vector<Entry> entries = {
            {"low", render::make_ammann_of({{5, 2}}, false), {{"render.ammann_mesh_from_px2", never_px}}},
            {"high", render::make_ammann_of({{64, 25}}, false), {{"render.ammann_mesh_from_px2", never_px}}},
            entry("mesh")};
        const std::vector<double> ms = easel.time_ms(entries, grazing_view(terrain), 5);
        table.row(fmt::format("{},{:.1f},{:.1f},{:.1f}", name, ms[0], ms[1], ms[2]));
    }
}

// Ammann 2010, table 2: numbers of levels of precision, cells of 75 samples; and what it costs to read the
// choices back.
void ammann_table_2(double patch_pixels) {
    Table table("ammann_table_2", "terrain,levels,ms,with_read_back_ms");
    const PaperTerrain terrain = paper_terrain("mountains");
    Easel easel(terrain, {1024, 768}, patch_pixels);
    std::vector<Entry> entries;
    const std::vector<int> numbers = {2, 4, 6, 8, 10};
    for (const int levels : numbers) {
        // From 64 samples to 6 and from 50 halvings to 5, by equal ratios.
        std::vector<glm::ivec2> steps;
        for (int level = 0; level < levels; ++level) {
            const double share = static_cast<double>(level) / (levels - 1);
            steps.emplace_back(std::lround(64 * std::pow(6.0 / 64, share)),
                               std::lround(50 * std::pow(5.0 / 50, share)));
        }
        for (const bool reads_back : {false, true})
            entries.push_back({fmt::format("{} levels", levels),
                               render::make_ammann_of(steps, reads_back),
                               {{"render.ammann_cell_samples", 75}}});
    }
    const std::vector<double> ms = easel.time_ms(entries, paper_flight(terrain, 5)[1], 9);
    for (std::size_t i = 0; i < numbers.size(); ++i)
        table.row(fmt::format("{},{},{:.2f},{:.2f}", terrain.name, numbers[i], ms[2 * i], ms[2 * i + 1]));
}

// Ammann 2010, figure 6: sizes of cells.
void ammann_figure_6(double patch_pixels) {
    Table table("ammann_figure_6", "terrain,cell_samples,ms");
    for (const std::string& name : paper_terrain_names()) {
        const PaperTerrain terrain = paper_terrain(name);
        Easel easel(terrain, {1024, 768}, patch_pixels);
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

// Ammann 2010, figure 5: error of both precisions by the angle and the distance of the view.
void ammann_figure_5(double patch_pixels) {
    Table table("ammann_figure_5", "terrain,angle_deg,distance,low_precision_db,high_precision_db");
    for (const std::string& name : paper_terrain_names()) {
        const PaperTerrain terrain = paper_terrain(name);
        Easel easel(terrain, small_picture, patch_pixels);
        const Entry mesh = entry("mesh");
        const std::vector<Entry> entries = {
            {"low", render::make_ammann_of({{5, 2}}, false), {{"render.ammann_mesh_from_px2", never_px}}},
            {"high", render::make_ammann_of({{64, 25}}, false), {{"render.ammann_mesh_from_px2", never_px}}}};
        const glm::dvec3 middle(0.5 * terrain.grid.width_m(), 0.5 * terrain.grid.height_m(), 1250);
        for (const double distance : {0.6, 1.0, 1.5})
            for (const double angle_deg : {10, 20, 30, 45, 60, 75, 89}) {
                const double angle = angle_deg * 3.14159265358979 / 180;
                const glm::dvec3 way(0.6 * std::cos(angle), 0.8 * std::cos(angle), std::sin(angle));
                const render::Camera camera{middle + distance * terrain.grid.width_m() * way, middle, 45};
                std::vector<Psnr> psnr(2, Psnr(terrain));
                const std::vector<float> by_mesh = easel.distances(mesh, camera);
                for (std::size_t i = 0; i < 2; ++i) psnr[i].add(easel.distances(entries[i], camera), by_mesh);
                table.row(fmt::format("{},{},{},{:.1f},{:.1f}", name, angle_deg, distance, psnr[0].db(),
                                      psnr[1].db()));
            }
    }
}

}  // namespace

void bench_papers(double patch_pixels, const std::string& only) {
    std::filesystem::create_directories("out/papers");
    const std::vector<std::pair<std::string, void (*)(double)>> tables = {
        {"ammann_table_1", ammann_table_1},
        {"ammann_table_2", ammann_table_2},
        {"ammann_figure_5", ammann_figure_5},
        {"ammann_figure_6", ammann_figure_6},
        {"flight", flights},
        {"survey", surveys}};
    std::string names;
    bool found = only.empty();
    for (const auto& [name, measure] : tables) {
        names += (names.empty() ? "" : ", ") + name;
        found = found || only == name;
    }
    if (!found) throw Error(fmt::format("there is no table '{}', it must be one of: {}", only, names));
    for (const auto& [name, measure] : tables)
        if (only.empty() || only == name) measure(patch_pixels);
}

}  // namespace talus::bench
