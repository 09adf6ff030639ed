#include "tests/scenes/scenes.h"

#include <cstdlib>
#include <random>
#include <stdexcept>

#include "sim/terrain/generate.h"

namespace talus::scenes {

std::vector<std::string> names() {
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
    throw std::invalid_argument("no scene " + name);
}

}  // namespace talus::scenes
