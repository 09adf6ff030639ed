#include "tests/bench/papers/easel.h"

#include <fmt/format.h>

#include "tests/bench/measure.h"

namespace talus::bench {

Entry entry(const std::string& method, const render::OwnNumbers& numbers, const std::string& name) {
    return {name.empty() ? method : name, render::method_named(method).make(render::Detail::none), numbers};
}

Entry steps_of(const std::string& method) {
    return {method, render::method_named(method).make(render::Detail::steps)};
}

Entry ammann(double k, double t) {
    return entry("ammann", {{"render.ammann_range", k}, {"render.ammann_mesh_from_px2", t}},
                 fmt::format("ammann k {:g} T {:g}", k, t));
}

Entry clipmap(int choice, int levels, const std::string& name) {
    return entry("clipmap", {{"render.clipmap_samples", choice}, {"render.clipmap_levels", levels}}, name);
}

PaperEasel::PaperEasel(const PaperTerrain& terrain, glm::ivec2 size, double patch_pixels)
    : terrain_(bedrock_terrain(terrain.grid, terrain.heights)),
      pyramid_(terrain_),
      size_(size),
      patch_pixels_(patch_pixels),
      target_(size.x, size.y) {
    pyramid_.refresh(terrain_);
}

void PaperEasel::draw(const Entry& entry, const render::Camera& camera) {
    entry.method({terrain_, pyramid_, camera, size_.x, size_.y, 0.5, patch_pixels_, target_.framebuffer(),
                  nullptr, entry.numbers});
    const std::vector<float> wait = target_.read_distances(1, 1);
}

std::vector<float> PaperEasel::distances(const Entry& entry, const render::Camera& camera) {
    draw(entry, camera);
    return target_.read_distances(size_.x, size_.y);
}

std::vector<float> PaperEasel::details(const Entry& entry, const render::Camera& camera) {
    draw(entry, camera);
    return target_.read_details(size_.x, size_.y);
}

std::vector<double> PaperEasel::time_ms(const std::vector<Entry>& entries, const render::Camera& camera,
                                        int rounds) {
    std::vector<Contestant> contestants;
    contestants.reserve(entries.size());
    for (const Entry& one : entries)
        if (one.method.finish) one.method.finish(terrain_);
    for (const Entry& one : entries)
        contestants.push_back({one.name, [this, &one, &camera] { draw(one, camera); }});
    std::vector<double> times = interleave(contestants, rounds);
    for (double& time : times) time *= 1e3;
    return times;
}

}  // namespace talus::bench
