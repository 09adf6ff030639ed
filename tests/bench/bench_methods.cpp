// The methods against each other: the survey's twelve cameras and mixed views at 2049², and a flight at
// 4096².
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>

#include "app/core/flight.h"
#include "render/hits_target.h"
#include "render/methods/method.h"
#include "render/survey.h"
#include "sim/terrain/generate.h"
#include "tests/bench/measure.h"
#include "tests/scenes/scenes.h"

namespace talus::bench {
namespace {

// A generated terrain and every method, drawn and timed.
class Stage {
  public:
    Stage(const Grid& grid, std::vector<float> of, double patch_pixels)
        : heights(std::move(of)),
          terrain_(bedrock_terrain(grid, heights)),
          pyramid_(terrain_),
          patch_pixels_(patch_pixels) {
        pyramid_.refresh(terrain_);
    }

    // Median seconds of the methods named, in that order.
    std::vector<double> time(const render::Camera& camera, const std::vector<std::string>& names,
                             int rounds) {
        std::vector<Contestant> contestants;
        for (const std::string& name : names) {
            auto known = made_.find(name);
            if (known == made_.end())
                known = made_.emplace(name, render::method_named(name).make(render::Detail::none)).first;
            contestants.push_back({name, [&, method = &known->second] {
                                       (*method)({terrain_, pyramid_, camera, width, height, 0.5,
                                                  patch_pixels_, target_.framebuffer()});
                                       const std::vector<float> wait = target_.read_distances(1, 1);
                                   }});
        }
        return interleave(contestants, rounds);
    }

    // Shares of the picture: mesh, rays, ended early.
    std::array<double, 3> kinds(const render::Camera& camera) {
        telling_({terrain_, pyramid_, camera, width, height, 0.5, patch_pixels_, target_.framebuffer()});
        std::array<double, 4> counts{};
        for (const float kind : target_.read_details(width, height))
            ++counts[static_cast<std::size_t>(std::clamp(kind, 0.0F, 3.0F))];
        return {counts[1] / (width * height), counts[2] / (width * height), counts[3] / (width * height)};
    }

    std::vector<float> heights;

  private:
    Terrain terrain_;
    render::Pyramid pyramid_;
    double patch_pixels_;
    render::HitsTarget target_{width, height};
    std::map<std::string, render::Method> made_;
    render::Method telling_ = render::make_hybrid(render::Detail::kind);
};

double ground_at(const Grid& grid, const std::vector<float>& heights, double x, double y) {
    return heights[static_cast<std::size_t>(std::lround(grid.row_of(y))) * grid.nx +
                   static_cast<std::size_t>(std::lround(grid.column_of(x)))];
}

// Low over ground, where near patches are large and far ones small.
std::vector<render::NamedCamera> mixed_views(const Grid& grid, const std::vector<float>& heights) {
    const double e = grid.width_m();
    const auto low = [&](const char* name, double x, double y, double above_m, double pitch_deg,
                         double azimuth_deg) {
        const glm::dvec3 eye(x * e, y * e, ground_at(grid, heights, x * e, y * e) + above_m);
        const double pitch = pitch_deg * std::numbers::pi / 180;
        const double azimuth = azimuth_deg * std::numbers::pi / 180;
        return render::NamedCamera{name,
                                   {eye,
                                    eye + glm::dvec3(std::sin(azimuth) * std::cos(pitch),
                                                     std::cos(azimuth) * std::cos(pitch), std::sin(pitch)),
                                    55}};
    };
    return {low("walk, 2 m", 0.5, 0.5, 2, -5, 45),
            low("walk, 2 m, valley", 0.7, 0.3, 2, -3, 320),
            low("low, 30 m", 0.4, 0.5, 30, -15, 100),
            low("low, 100 m", 0.3, 0.4, 100, -15, 200),
            low("level, 60 m", 0.5, 0.5, 60, -1, 42),
            low("300 m, -25 degrees", 0.3, 0.4, 300, -25, 30),
            low("1000 m, -45 degrees", 0.6, 0.4, 1000, -45, 300)};
}

}  // namespace

void bench_methods(double patch_pixels) {
    const Grid grid{2049, 2049, 10, 10};
    Stage stage(grid, generate_heights(grid, {"mountains", 4, 2500}), patch_pixels);
    std::vector<render::NamedCamera> views = render::survey(grid, stage.heights);
    const std::size_t surveyed = views.size();
    for (render::NamedCamera& view : mixed_views(grid, stage.heights)) views.push_back(std::move(view));
    const std::size_t on_mountains = views.size();
    scenes::Scene shore = scenes::shore();
    Stage flat(shore.grid, std::move(shore.heights), patch_pixels);
    for (const render::Camera& camera : scenes::shore_views())
        views.push_back({fmt::format("shore {}", views.size() - on_mountains + 1), camera});
    fmt::print("{:<22} {:>8} {:>8} {:>8} {:>8} {:>12} {:>7} {:>7} {:>7}\n", "view, ms", "exact", "boxes",
               "mesh", "hybrid", "hybrid/best", "mesh %", "rays %", "early %");
    std::vector<double> ratios;
    for (std::size_t i = 0; i < views.size(); ++i) {
        Stage& here = i < on_mountains ? stage : flat;
        const std::vector<double> s = here.time(views[i].camera, {"exact", "boxes", "mesh", "hybrid"}, 9);
        const double ratio = s[3] / std::min(s[0], s[2]);
        if (i < surveyed) ratios.push_back(ratio);
        const std::array<double, 3> kinds = here.kinds(views[i].camera);
        fmt::print("{:<22} {:>8.1f} {:>8.1f} {:>8.1f} {:>8.1f} {:>12.2f} {:>7.1f} {:>7.1f} {:>7.1f}\n",
                   views[i].name, 1e3 * s[0], 1e3 * s[1], 1e3 * s[2], 1e3 * s[3], ratio, 100 * kinds[0],
                   100 * kinds[1], 100 * kinds[2]);
    }
    std::sort(ratios.begin(), ratios.end());
    fmt::print("survey: hybrid to the better of mesh and exact: median {:.3f}, worst {:.3f}\n",
               0.5 * (ratios[(ratios.size() - 1) / 2] + ratios[ratios.size() / 2]), ratios.back());

    const Grid large{4096, 4096, 10, 10};
    Stage wide(large, generate_heights(large, {"mountains", 4, 2500}), patch_pixels);
    std::vector<render::Camera> keys;
    const double e = large.width_m();
    for (const glm::dvec2 at : {glm::dvec2(0.15, 0.1), {0.4, 0.35}, {0.7, 0.4}, {0.8, 0.75}, {0.5, 0.85}}) {
        const glm::dvec3 eye(at * e, ground_at(large, wide.heights, at.x * e, at.y * e) + 400);
        keys.push_back({eye, glm::dvec3(0.5 * e, 0.5 * e, 900), 55});
    }
    double mesh_s = 0;
    double exact_s = 0;
    double hybrid_s = 0;
    for (const render::Camera& camera : app::fly_along(keys, 12)) {
        const std::vector<double> s = wide.time(camera, {"exact", "mesh", "hybrid"}, 3);
        exact_s += s[0];
        mesh_s += s[1];
        hybrid_s += s[2];
    }
    fmt::print(
        "flight at 4096²: exact {:.1f}, mesh {:.1f}, hybrid {:.1f} ms a frame; mesh to hybrid {:.1f}\n",
        1e3 * exact_s / 12, 1e3 * mesh_s / 12, 1e3 * hybrid_s / 12, mesh_s / hybrid_s);
}

}  // namespace talus::bench
