#include "tests/bench/papers/terrains.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "app/core/flight.h"
#include "sim/operation.h"
#include "sim/terrain/generate.h"
#include "tests/scenes/scenes.h"

namespace talus::bench {
namespace {

double ground_at(const PaperTerrain& terrain, glm::dvec2 place) {
    const auto column = static_cast<std::size_t>(std::lround(terrain.grid.column_of(place.x)));
    const auto row = static_cast<std::size_t>(std::lround(terrain.grid.row_of(place.y)));
    return terrain.heights[row * terrain.grid.nx + column];
}

double relief_of(const PaperTerrain& terrain) {
    const auto [low, high] = std::minmax_element(terrain.heights.begin(), terrain.heights.end());
    return *high - *low;
}

std::vector<float> resampled(const Grid& grid, const std::vector<float>& heights, int side) {
    return made_of(Resample{side, side}, bedrock_terrain(grid, heights)).ground();
}

// Measured elevation with more samples than the file has. What lies between the file's samples is generated:
// the part of mountains of the same relief that the file's spacing cannot hold. The sea stays flat.
PaperTerrain detailed(const std::string& name, const scenes::Scene& scene, int side) {
    const Grid grid{side, side, scene.grid.width_m() / (side - 1), scene.grid.height_m() / (side - 1)};
    PaperTerrain terrain{name, grid, resampled(scene.grid, scene.heights, side)};
    const std::vector<float> made = generate_heights(grid, {"mountains", 4, relief_of(terrain)});
    const std::vector<float> coarse = resampled(grid, made, scene.grid.nx);
    const std::vector<float> smooth =
        resampled({scene.grid.nx, scene.grid.nx, grid.width_m() / (scene.grid.nx - 1),
                   grid.height_m() / (scene.grid.nx - 1)},
                  coarse, side);
    for (std::size_t i = 0; i < made.size(); ++i)
        terrain.heights[i] += std::clamp((terrain.heights[i] - 1) / 20, 0.0F, 1.0F) * (made[i] - smooth[i]);
    return terrain;
}

}  // namespace

std::vector<std::string> paper_terrain_names() {
    std::vector<std::string> names = {"high_amplitude", "mountains_1024", "mountains", "spectrogram"};
    if (std::getenv("TALUS_DATA")) names.emplace_back("coast");
    return names;
}

PaperTerrain paper_terrain(const std::string& name) {
    if (name == "mountains_1024") {
        PaperTerrain terrain = paper_terrain_of(1024);
        terrain.name = name;
        return terrain;
    }
    if (name == "coast") return detailed(name, scenes::make(name), 4096);
    const int side = name == "high_amplitude" ? 2048 : 4096;
    const Grid grid{side, side, 10, 10};
    return {name, grid, generate_heights(grid, {name, 4, 2500})};
}

PaperTerrain paper_terrain_of(int side) {
    const Grid grid{side, side, 20480.0 / side, 20480.0 / side};
    return {"mountains", grid, generate_heights(grid, {"mountains", 4, 2500})};
}

std::vector<render::Camera> paper_walk(const PaperTerrain& terrain, int frames) {
    std::vector<render::Camera> cameras = paper_flight(terrain, frames);
    for (render::Camera& camera : cameras) {
        camera.eye.z = ground_at(terrain, glm::dvec2(camera.eye)) + relief_of(terrain) / 500;
        camera.target.z = camera.eye.z;
    }
    return cameras;
}

std::vector<render::Camera> paper_flight(const PaperTerrain& terrain, int frames) {
    const glm::dvec2 size(terrain.grid.width_m(), terrain.grid.height_m());
    const glm::dvec2 middle = 0.5 * size;
    std::vector<render::Camera> keys;
    for (const glm::dvec2 at : {glm::dvec2(0.15, 0.1), {0.4, 0.35}, {0.7, 0.4}, {0.8, 0.75}, {0.5, 0.85}}) {
        const glm::dvec2 place = at * size;
        keys.push_back({glm::dvec3(place, ground_at(terrain, place) + relief_of(terrain) / 6),
                        glm::dvec3(middle, ground_at(terrain, middle)), 55});
    }
    std::vector<render::Camera> cameras = app::fly_along(keys, frames);
    // Between the keys hills may be higher.
    for (render::Camera& camera : cameras)
        camera.eye.z =
            std::max(camera.eye.z, ground_at(terrain, glm::dvec2(camera.eye)) + relief_of(terrain) / 30);
    return cameras;
}

render::Camera grazing_view(const PaperTerrain& terrain) {
    const glm::dvec2 size(terrain.grid.width_m(), terrain.grid.height_m());
    const glm::dvec2 place = 0.1 * size;
    const glm::dvec3 eye(place, ground_at(terrain, place) + 0.1 * relief_of(terrain));
    return {eye, glm::dvec3(0.9 * size, eye.z - 0.1 * relief_of(terrain)), 50};
}

}  // namespace talus::bench
