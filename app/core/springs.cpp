#include "app/core/springs.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "app/core/bilinear.h"
#include "app/core/session.h"
#include "sim/error.h"
#include "sim/terrain/springs.h"

namespace talus::app {
namespace {

// The spring becomes another one, or none. Those behind it are placed again, so that each keeps its number.
void change(Session& session, const char* name, const Spring& spring, const Spring& to) {
    const std::vector<Spring>& all = session.simulation().springs();
    const auto found = std::find(all.begin(), all.end(), spring);
    if (to == spring) return;
    if (found == all.end())
        throw Error(fmt::format(
            "the spring at {:.6g},{:.6g} m was changed or taken away meanwhile: look for it again",
            spring.x_m, spring.y_m));
    std::vector<Operation> acts;
    for (auto one = found; one != all.end(); ++one) acts.emplace_back(PlaceSpring{one->x_m, one->y_m, 0});
    acts.emplace_back(to);
    const Grid& grid = session.simulation().terrain().grid();
    for (auto one = std::next(found); one != all.end(); ++one)
        if (sample_of(grid, *one) != sample_of(grid, to)) acts.emplace_back(*one);
    session.apply_together(name, acts);
}

// Column and row.
glm::dvec2 place_of(const Grid& grid, const Spring& spring) {
    return {grid.column_of(spring.x_m), grid.row_of(spring.y_m)};
}

// The four samples that it lies between: the first one's column and row.
glm::ivec2 patch_of(const Grid& grid, const Spring& spring) {
    return glm::clamp(glm::ivec2(glm::floor(place_of(grid, spring))), glm::ivec2(0),
                      glm::ivec2(grid.nx - 2, grid.ny - 2));
}

}  // namespace

void place_spring(Session& session, glm::dvec2 place_m) {
    session.apply_together(
        "spring", {PlaceSpring{place_m.x, place_m.y, session.view().number("spring.rate_m3_per_s")}});
}

void move_spring(Session& session, const Spring& spring, glm::dvec2 place_m) {
    change(session, "move a spring", spring, {place_m.x, place_m.y, spring.rate_m3_per_s});
}

void set_spring_rate(Session& session, const Spring& spring, double rate_m3_per_s) {
    change(session, rate_m3_per_s > 0 ? "rate of a spring" : "remove a spring", spring,
           {spring.x_m, spring.y_m, rate_m3_per_s});
}

bool SpringHeights::pending() const {
    return std::any_of(readbacks_.begin(), readbacks_.end(), [](const auto& one) { return one->pending(); });
}

void SpringHeights::follow(const Simulation& simulation) {
    const std::vector<Spring>& springs = simulation.springs();
    const Terrain& terrain = simulation.terrain();
    bool asks = false;
    if (springs != of_) {
        of_ = springs;
        heights_m_.assign(springs.size(), std::nullopt);
        readbacks_.clear();
        for (std::size_t i = 0; i < springs.size(); ++i)
            readbacks_.push_back(std::make_unique<gpu::Readback>());
        asks = true;
    }
    for (std::size_t i = 0; i < readbacks_.size(); ++i)
        if (const auto corners = readbacks_[i]->poll())
            heights_m_[i] = bilinear(
                place_of(terrain.grid(), of_[i]) - glm::dvec2(patch_of(terrain.grid(), of_[i])),
                glm::ivec2(2), [&](int column, int row) {
                    return static_cast<double>((*corners)[static_cast<std::size_t>(row) * 2 + column]);
                });
    if ((!asks && changes_ == terrain.tiles.now()) || pending()) return;
    changes_ = terrain.tiles.now();
    for (std::size_t i = 0; i < readbacks_.size(); ++i) {
        const glm::ivec2 patch = patch_of(terrain.grid(), of_[i]);
        readbacks_[i]->start(terrain.ground, {patch.x, patch.y, 2, 2});
    }
}

}  // namespace talus::app
