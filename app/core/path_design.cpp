#include "app/core/path_design.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace talus::app {
namespace {

constexpr std::size_t most_stations = 4096;
// Places on each side where a path's slope is looked for the ground.
constexpr int most_side_steps = 200;

// A point of the spline's piece between b and c, by Barry and Goldman's pyramid; knots by the roots of the
// distances.
glm::dvec2 on_spline(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c, glm::dvec2 d, double share) {
    const auto knot = [](glm::dvec2 from, glm::dvec2 to) {
        return std::max(std::sqrt(glm::distance(from, to)), 1e-9);
    };
    const double t0 = 0;
    const double t1 = t0 + knot(a, b);
    const double t2 = t1 + knot(b, c);
    const double t3 = t2 + knot(c, d);
    const double t = t1 + share * (t2 - t1);
    const auto between = [&](glm::dvec2 from, glm::dvec2 to, double low, double high) {
        return ((high - t) * from + (t - low) * to) / (high - low);
    };
    const glm::dvec2 ab = between(a, b, t0, t1);
    const glm::dvec2 bc = between(b, c, t1, t2);
    const glm::dvec2 cd = between(c, d, t2, t3);
    return between(between(ab, bc, t0, t2), between(bc, cd, t1, t3), t1, t2);
}

std::vector<double> stations_of(const std::vector<glm::dvec2>& line) {
    std::vector<double> stations = {0};
    for (std::size_t i = 1; i < line.size(); ++i)
        stations.push_back(stations.back() + glm::distance(line[i - 1], line[i]));
    return stations;
}

// Even steps along a line of short pieces.
std::vector<glm::dvec2> evenly(const std::vector<glm::dvec2>& line, std::size_t count) {
    const std::vector<double> stations = stations_of(line);
    std::vector<glm::dvec2> even;
    even.reserve(count);
    std::size_t piece = 1;
    for (std::size_t i = 0; i < count; ++i) {
        const double at = stations.back() * static_cast<double>(i) / static_cast<double>(count - 1);
        while (piece + 1 < line.size() && stations[piece] < at) ++piece;
        const double length = std::max(stations[piece] - stations[piece - 1], 1e-12);
        even.push_back(glm::mix(line[piece - 1], line[piece], (at - stations[piece - 1]) / length));
    }
    return even;
}

// The mean of the ground so far before and behind each station.
std::vector<double> smoothed(const std::vector<double>& stations_m, const std::vector<double>& heights_m,
                             double half_m) {
    std::vector<double> means;
    means.reserve(heights_m.size());
    for (const double at : stations_m) {
        // As far on both sides, so that ends stay.
        const double reach = std::min({half_m, at - stations_m.front(), stations_m.back() - at}) + 1e-9;
        const auto first =
            std::lower_bound(stations_m.begin(), stations_m.end(), at - reach) - stations_m.begin();
        const auto end =
            std::upper_bound(stations_m.begin(), stations_m.end(), at + reach) - stations_m.begin();
        means.push_back(std::accumulate(heights_m.begin() + first, heights_m.begin() + end, 0.0) /
                        static_cast<double>(end - first));
    }
    return means;
}

std::vector<double> profile_of(const PathWishes& wishes, const std::vector<double>& stations_m,
                               const std::vector<double>& ground_m) {
    std::vector<double> heights = smoothed(stations_m, ground_m, wishes.width_m);
    switch (wishes.kind) {
        case PathKind::road:
            return road_profile(stations_m, heights, wishes.steepest);
        case PathKind::wall:
            for (double& height : heights) height += wishes.height_m;
            return heights;
        case PathKind::river:
            for (std::size_t i = 0; i < heights.size(); ++i) {
                heights[i] -= wishes.depth_m;
                if (i == 0) continue;
                const double fallen = wishes.least_fall * (stations_m[i] - stations_m[i - 1]);
                heights[i] = std::min(heights[i], heights[i - 1] - fallen);
            }
            return heights;
        case PathKind::ditch:
        case PathKind::breach:
            for (double& height : heights) height -= wishes.depth_m;
            return heights;
    }
    return heights;
}

// What the ground does to a path beside one of its points.
struct Side {
    double reach_m = 0;
    bool meets = true;
};

// How far a side goes on from the edge of the path's width until it meets the ground.
Side side_at(const PathDab& path, glm::dvec3 point, glm::dvec2 outwards, double step_m,
             const std::function<double(glm::dvec2)>& ground_at) {
    for (int i = 0; i <= most_side_steps; ++i) {
        const double beside = i * step_m;
        const double ground = ground_at(glm::dvec2(point) + (path.half_width_m + beside) * outwards);
        const bool is_cut = path.cuts && ground > point.z + beside * path.cut_slope;
        const bool is_filled = path.fills && ground < point.z - beside * path.fill_slope;
        if (!is_cut && !is_filled) return {path.half_width_m + beside, true};
    }
    return {path.half_width_m + most_side_steps * step_m, false};
}

// Cut, fill and sides all along.
void look_beside(const std::vector<glm::dvec3>& line, double spacing_m,
                 const std::function<double(glm::dvec2)>& ground_at, PathDesign& design) {
    const PathDab& path = design.path;
    for (std::size_t i = 0; i < line.size(); ++i) {
        const glm::dvec2 before = glm::dvec2(line[i > 0 ? i - 1 : 0]);
        const glm::dvec2 behind = glm::dvec2(line[std::min(i + 1, line.size() - 1)]);
        const double run = glm::distance(before, behind);
        if (!(run > 0)) continue;
        const glm::dvec2 way = (behind - before) / run;
        const glm::dvec2 left(-way.y, way.x);
        for (const double aside : {-1.0, -0.5, 0.0, 0.5, 1.0}) {
            const double rise = ground_at(glm::dvec2(line[i]) + aside * path.half_width_m * left) - line[i].z;
            design.deepest_cut_m = std::max(design.deepest_cut_m, rise);
            design.highest_fill_m = std::max(design.highest_fill_m, -rise);
        }
        for (const double sign : {-1.0, 1.0}) {
            const Side side = side_at(path, line[i], sign * left, spacing_m, ground_at);
            design.reach_m = std::max(design.reach_m, side.reach_m + 2 * spacing_m);
            design.sides_meet = design.sides_meet && side.meets;
        }
    }
}

}  // namespace

std::vector<glm::dvec2> spline_through(const std::vector<glm::dvec2>& points_m, double step_m) {
    constexpr int fine = 32;
    std::vector<glm::dvec2> line = {points_m.front()};
    const auto last = static_cast<std::ptrdiff_t>(points_m.size()) - 1;
    // Beyond the ends the curve goes on as it came.
    const auto point = [&](std::ptrdiff_t i) {
        if (i < 0) return 2.0 * points_m[0] - points_m[1];
        if (i > last)
            return 2.0 * points_m[static_cast<std::size_t>(last)] -
                   points_m[static_cast<std::size_t>(last) - 1];
        return points_m[static_cast<std::size_t>(i)];
    };
    for (std::ptrdiff_t i = 0; i < last; ++i)
        for (int k = 1; k <= fine; ++k)
            line.push_back(
                on_spline(point(i - 1), point(i), point(i + 1), point(i + 2), static_cast<double>(k) / fine));
    const double length = stations_of(line).back();
    const auto count = static_cast<std::size_t>(
        std::clamp(std::ceil(length / step_m) + 1, 2.0, static_cast<double>(most_stations)));
    return evenly(line, count);
}

std::vector<double> road_profile(const std::vector<double>& stations_m, const std::vector<double>& ground_m,
                                 double steepest) {
    const std::size_t count = ground_m.size();
    // The lowest line above the ground and the highest below it that keep the grade: between them lies the
    // one that strays least.
    std::vector<double> above = ground_m;
    std::vector<double> below = ground_m;
    const auto pass = [&](std::size_t i, std::size_t from) {
        const double rise = steepest * std::abs(stations_m[i] - stations_m[from]);
        above[i] = std::max(above[i], above[from] - rise);
        below[i] = std::min(below[i], below[from] + rise);
    };
    for (std::size_t i = 1; i < count; ++i) pass(i, i - 1);
    for (std::size_t i = count - 1; i-- > 0;) pass(i, i + 1);
    std::vector<double> heights(count);
    for (std::size_t i = 0; i < count; ++i) heights[i] = (above[i] + below[i]) / 2;
    // From both ends as far as the grade lets it.
    const double length = stations_m.back() - stations_m.front();
    if (std::abs(ground_m.back() - ground_m.front()) > steepest * length) return heights;
    for (std::size_t i = 0; i < count; ++i) {
        const double from_first = steepest * (stations_m[i] - stations_m.front());
        const double from_last = steepest * (stations_m.back() - stations_m[i]);
        heights[i] = std::clamp(heights[i], ground_m.front() - from_first, ground_m.front() + from_first);
        heights[i] = std::clamp(heights[i], ground_m.back() - from_last, ground_m.back() + from_last);
    }
    return heights;
}

std::vector<glm::dvec3> simplified(const std::vector<glm::dvec3>& line_m, double tolerance_m) {
    std::vector<bool> kept(line_m.size(), false);
    kept.front() = kept.back() = true;
    std::vector<std::pair<std::size_t, std::size_t>> pieces = {{0, line_m.size() - 1}};
    while (!pieces.empty()) {
        const auto [first, last] = pieces.back();
        pieces.pop_back();
        const glm::dvec3 way = line_m[last] - line_m[first];
        std::size_t farthest = first;
        double distance_m = tolerance_m;
        for (std::size_t i = first + 1; i < last; ++i) {
            const glm::dvec3 from = line_m[i] - line_m[first];
            const double share =
                std::clamp(glm::dot(from, way) / std::max(glm::dot(way, way), 1e-30), 0.0, 1.0);
            const double off_m = glm::length(from - share * way);
            if (off_m <= distance_m) continue;
            farthest = i;
            distance_m = off_m;
        }
        if (farthest == first) continue;
        kept[farthest] = true;
        pieces.emplace_back(first, farthest);
        pieces.emplace_back(farthest, last);
    }
    std::vector<glm::dvec3> line;
    for (std::size_t i = 0; i < line_m.size(); ++i)
        if (kept[i]) line.push_back(line_m[i]);
    return line;
}

PathDesign design_path(const std::vector<glm::dvec2>& points_m, const PathWishes& wishes, double spacing_m,
                       const std::function<double(glm::dvec2)>& ground_at) {
    const std::vector<glm::dvec2> curve = spline_through(points_m, spacing_m);
    const std::vector<double> stations = stations_of(curve);
    std::vector<double> ground;
    ground.reserve(curve.size());
    for (const glm::dvec2 place : curve) ground.push_back(ground_at(place));
    const std::vector<double> heights = profile_of(wishes, stations, ground);

    PathDesign design;
    PathDab& path = design.path;
    path.kind = wishes.kind;
    path.half_width_m = wishes.width_m / 2;
    path.cut_slope = path.fill_slope = wishes.side_slope;
    path.cuts = wishes.kind != PathKind::wall;
    path.fills = wishes.kind == PathKind::road || wishes.kind == PathKind::wall;
    std::vector<glm::dvec3> line;
    line.reserve(curve.size());
    for (std::size_t i = 0; i < curve.size(); ++i) {
        line.emplace_back(curve[i], heights[i]);
        const double run = i > 0 ? stations[i] - stations[i - 1] : 0;
        if (run > 0) design.steepest = std::max(design.steepest, std::abs(heights[i] - heights[i - 1]) / run);
    }
    design.length_m = stations.back();
    if (wishes.kind == PathKind::road)
        design.misses_m =
            std::max(std::abs(heights.front() - ground.front()), std::abs(heights.back() - ground.back()));
    look_beside(line, spacing_m, ground_at, design);
    // Less than anybody sees.
    path.points_m = simplified(line, std::min(0.01, 0.01 * spacing_m));
    for (const glm::dvec3& point : path.points_m) design.ground_m.push_back(ground_at(glm::dvec2(point)));
    return design;
}

Dab dab_of(const PathDesign& design) {
    Dab dab;
    dab.effect = design.path;
    dab.x_m = design.path.points_m.front().x;
    dab.y_m = design.path.points_m.front().y;
    dab.target_m = design.path.points_m.front().z;
    dab.radius_m = design.reach_m;
    return dab;
}

}  // namespace talus::app
