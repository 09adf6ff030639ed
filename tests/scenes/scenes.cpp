#include "tests/scenes/scenes.h"

#include <algorithm>
#include <cstdlib>
#include <random>
#include <stdexcept>

#include "sim/io/heightmap.h"
#include "sim/terrain/generate.h"

namespace talus::scenes {

std::vector<std::string> names() {
    if (std::getenv("TALUS_DATA")) return {"fbm", "spikes", "bigtujunga", "coast"};
    return {"fbm", "spikes", "ridges", "rough"};
}

Scene make(const std::string& name) {
    if (name == "fbm") {
        const Grid grid{513, 513, 10, 10};
        return {grid, generate_heights(grid, {"hills", 3, 600})};
    }
    if (name == "spikes") {
        const Grid grid{300, 411, 5, 7};
        Scene scene{grid, std::vector<float>(grid.count(), 0.0F)};
        std::mt19937 random(11);
        for (float& h : scene.heights)
            if (random() % 97 == 0) h = static_cast<float>(random() % 400);
        return scene;
    }
    if (name == "ridges") {
        const Grid grid{1197, 643, 30, 30};
        return {grid, generate_heights(grid, {"mountains", 5, 2000})};
    }
    if (name == "rough") {
        const Grid grid{1025, 1025, 60, 92};
        return {grid, generate_heights(grid, {"mountains", 9, 2500})};
    }
    const auto real_file = [](const char* file) {
        io::Heightmap heightmap =
            io::read_heightmap(std::filesystem::path(std::getenv("TALUS_DATA")) / file, {});
        return Scene{heightmap.grid, std::move(heightmap.heights)};
    };
    if (name == "bigtujunga") return real_file("bigtujunga_30m_1197x643.tif");
    if (name == "coast") return real_file("santa_ynez_coast_30m_1537.tif");
    throw std::invalid_argument("no scene " + name);
}

Scene shore() {
    const Grid grid{1025, 1025, 30, 30};
    Scene scene{grid, generate_heights(grid, {"hills", 6, 700})};
    for (int row = 0; row < grid.ny; ++row)
        for (int column = 0; column < grid.nx; ++column) {
            const double inland = std::clamp(4 * (0.5 - static_cast<double>(row) / grid.ny), 0.0, 1.0);
            scene.heights[static_cast<std::size_t>(row) * grid.nx + column] *= static_cast<float>(inland);
        }
    return scene;
}

std::vector<render::Camera> shore_views() {
    constexpr double width_m = 1024 * 30;
    std::vector<render::Camera> cameras;
    for (const double share : {0.3, 0.5, 0.7}) {
        const glm::dvec3 eye(share * width_m, 0.3 * width_m, 110);
        cameras.push_back({eye, eye + glm::dvec3(1500, 6000, -450), 50});
    }
    return cameras;
}

}  // namespace talus::scenes
