#include "app/core/path_draft.h"

#include <algorithm>

#include "app/core/bilinear.h"

namespace talus::app {

double PathDraft::Ground::at(glm::dvec2 place_m) const {
    const glm::ivec2 count(grid.nx, grid.ny);
    const glm::dvec2 place(grid.column_of(place_m.x), grid.row_of(place_m.y));
    return bilinear(glm::clamp(place, glm::dvec2(0), glm::dvec2(count - 1)), count, [&](int column, int row) {
        return static_cast<double>(heights_m[static_cast<std::size_t>(row) * grid.nx + column]);
    });
}

void PathDraft::add(glm::dvec2 point_m) {
    if (built_revision_) points_m_.clear();
    built_revision_.reset();
    points_m_.push_back(point_m);
}

void PathDraft::move(std::size_t index, glm::dvec2 point_m) {
    if (points_m_[index] == point_m) return;
    points_m_[index] = point_m;
    built_revision_.reset();
}

void PathDraft::remove_last() {
    if (!points_m_.empty()) points_m_.pop_back();
    built_revision_.reset();
}

void PathDraft::turn_round() {
    std::reverse(points_m_.begin(), points_m_.end());
    built_revision_.reset();
}

std::optional<std::size_t> PathDraft::point_near(glm::dvec2 place_m, double reach_m) const {
    std::optional<std::size_t> nearest;
    double nearest_m = reach_m;
    for (std::size_t i = 0; i < points_m_.size(); ++i) {
        const double distance_m = glm::distance(points_m_[i], place_m);
        if (distance_m > nearest_m) continue;
        nearest = i;
        nearest_m = distance_m;
    }
    return nearest;
}

void PathDraft::follow(const Simulation& simulation, const Parameters& view, bool may_read) {
    const PathWishes wishes = path_wishes(view);
    if (points_m_.empty()) {
        design_.reset();
        heights_m_.clear();
        designed_points_m_.clear();
        return;
    }
    const bool of_other = !ground_ || ground_->terrain_number != simulation.terrain_number();
    if (of_other || (may_read && !ground_->is_of(simulation)))
        ground_ = std::make_shared<const Ground>(
            Ground{simulation.terrain_number(), simulation.journal().revision(), simulation.terrain().grid(),
                   simulation.terrain().ground.read_all<float>()});
    if (points_m_ == designed_points_m_ && wishes == designed_wishes_ && ground_ == designed_ground_) return;
    designed_points_m_ = points_m_;
    designed_wishes_ = wishes;
    designed_ground_ = ground_;
    design_.reset();
    heights_m_.clear();
    for (const glm::dvec2 point : points_m_) heights_m_.push_back(ground_->at(point));
    if (points_m_.size() >= 2)
        design_ = design_path(points_m_, wishes, std::min(ground_->grid.dx, ground_->grid.dy),
                              [&](glm::dvec2 place) { return ground_->at(place); });
}

std::optional<Dab> PathDraft::dab(const Simulation& simulation, const Parameters& view) {
    follow(simulation, view, true);
    if (!design_) return std::nullopt;
    Dab dab = dab_of(*design_);
    dab.material = view.choice("path.material") == "regolith" ? Material::regolith : Material::bedrock;
    return dab;
}

PathWishes path_wishes(const Parameters& view) {
    PathWishes wishes;
    wishes.kind = view.choice_as<PathKind>("path.kind");
    wishes.width_m = view.number("path.width_m");
    wishes.side_slope = view.number("path.side_slope");
    wishes.steepest = view.number("path.grade_percent") / 100;
    wishes.depth_m = view.number("path.depth_m");
    wishes.least_fall = view.number("path.fall_m_per_km") / 1000;
    wishes.height_m = view.number("path.height_m");
    return wishes;
}

std::vector<Parameter> path_parameters() {
    const PathWishes preset;
    std::vector<std::string> kinds = path_kind_names();
    kinds.pop_back();  // breaches are events
    return {
        choice("path.kind", preset.kind, kinds,
               "Road: level across its width, cut into what is higher and filled where it is lower; river: a "
               "bed "
               "that falls from its first point to its last; wall: raised; ditch: dug.")
            .labelled("Path"),
        number("path.width_m", preset.width_m, 0.01, 1e5, "m",
               "Width of the road, or of a bed's or wall's level part; unless set, three samples at least."),
        number("path.side_slope", preset.side_slope, 0.01, 1000, "m/m",
               "Rise over run of embankments and banks: 0.67 is 1 in 1.5."),
        number("path.grade_percent", 100 * preset.steepest, 0.01, 1000, "%", "Road: largest grade along it.")
            .labelled("Largest grade"),
        number("path.depth_m", preset.depth_m, 0, 1e4, "m",
               "River and ditch: depth of the bed below the ground."),
        number("path.fall_m_per_km", 1000 * preset.least_fall, 0, 1e5, "m/km", "River: least fall along it.")
            .labelled("Least fall"),
        number("path.height_m", preset.height_m, 0, 1e4, "m", "Wall: height above the ground."),
        choice("path.material", "bedrock", {"bedrock", "regolith"},
               "What embankments and walls are made of."),
    };
}

}  // namespace talus::app
