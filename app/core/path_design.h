#pragma once
#include <functional>
#include <glm/glm.hpp>
#include <vector>

#include "sim/passes/dab.h"

namespace talus::app {

/// What a path is to be. Slopes are rise over run.
struct PathWishes {
    PathKind kind = PathKind::road;
    double width_m = 8;
    double side_slope = 0.67;   ///< of embankments and banks
    double steepest = 0.08;     ///< road: largest grade
    double depth_m = 2;         ///< river, ditch: below the ground
    double least_fall = 0.001;  ///< river: from its first point to its last
    double height_m = 3;        ///< wall: above the ground
    bool operator==(const PathWishes&) const = default;
};

/// A path as it would be built.
struct PathDesign {
    PathDab path;
    std::vector<double> ground_m;  ///< under each of the path's points
    double length_m = 0;
    double steepest = 0;       ///< rise over run along it
    double deepest_cut_m = 0;  ///< across its width, all along
    double highest_fill_m = 0;
    double misses_m = 0;     ///< a road: how far its ends lie from the ground, for the climb is too long
    double reach_m = 0;      ///< from its middle to where its sides meet the ground, at most
    bool sides_meet = true;  ///< false: somewhere the ground is steeper than they, and they end in a step
};

/// A smooth curve through the points, by even steps: a centripetal Catmull-Rom spline (Yuksel et al. 2011).
/// At least two points. Long ones have longer steps.
std::vector<glm::dvec2> spline_through(const std::vector<glm::dvec2>& points_m, double step_m);

/// The heights of a road along its stations that is nowhere steeper than the grade and, of all such, strays
/// least from the ground; it begins and ends on the ground, where the grade allows.
std::vector<double> road_profile(const std::vector<double>& stations_m, const std::vector<double>& ground_m,
                                 double steepest);

/// The line without those points that lie within the tolerance of the line between others (Ramer 1972).
std::vector<glm::dvec3> simplified(const std::vector<glm::dvec3>& line_m, double tolerance_m);

/// The path through the points, at least two, over a ground with samples `spacing_m` apart.
PathDesign design_path(const std::vector<glm::dvec2>& points_m, const PathWishes& wishes, double spacing_m,
                       const std::function<double(glm::dvec2)>& ground_at);

/// The dab that builds it.
Dab dab_of(const PathDesign& design);

}  // namespace talus::app
