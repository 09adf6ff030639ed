#include "app/panels/marks.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <limits>
#include <utility>

namespace talus::app {
namespace {

constexpr ImU32 blue = IM_COL32(90, 190, 255, 255);
constexpr ImU32 yellow = IM_COL32(250, 205, 60, 255);
constexpr ImU32 dark = IM_COL32(20, 24, 30, 255);
constexpr ImU32 pale = IM_COL32(250, 205, 60, 110);

// What stands on the ground is as far away as that: it shows.
constexpr double nearer = 0.997;

// Where a point of the world is in the window. From the top, nothing hides it: it is as near as can be.
struct Place {
    ImVec2 at;
    double distance_m;
};

class Picture {
  public:
    Picture(const render::Camera& camera, const PictureArea& area)
        : camera_(camera), rays_(camera_rays(camera, area.size.x, area.size.y)), area_(area) {}

    // None: beside or behind the eye.
    std::optional<Place> place(glm::dvec3 point) const {
        const std::optional<glm::dvec2> at = render::place_in_picture(camera_, rays_, point);
        if (!at) return std::nullopt;
        return Place{{static_cast<float>(area_.corner.x + (0.5 + 0.5 * at->x) * area_.size.x),
                      static_cast<float>(area_.corner.y + (0.5 - 0.5 * at->y) * area_.size.y)},
                     camera_.is_parallel() ? 0 : glm::distance(point, camera_.eye)};
    }

  private:
    render::Camera camera_;
    render::CameraRays rays_;
    PictureArea area_;
};

struct Sign {
    Place foot;
    std::string name;
    ImU32 colour = yellow;
    std::optional<MovedMark> mark = std::nullopt;  // that it moves with
};
constexpr float sign_height = 28;  // of its middle over its foot
constexpr float sign_radius = 9;

// An end of a section, at the ground that was there when it was drawn.
glm::dvec3 end_of(const PlacedSection& one, bool second) {
    return second ? glm::dvec3(one.section.to_m, one.heights_m.y)
                  : glm::dvec3(one.section.from_m, one.heights_m.x);
}

// The farthest first.
std::vector<Sign> signs_of(const Session& session, const Picture& picture,
                           const std::optional<MovedMark>& moved) {
    std::vector<Sign> signs;
    const auto add = [&](const MapMark& mark, glm::dvec3 place, ImU32 colour) {
        const MovedMark stands{mark, moved && moved->mark == mark ? moved->place_m : place};
        if (const auto foot = picture.place(stands.place_m))
            signs.push_back({*foot, fmt::format("{}", mark.index + 1), colour, stands});
    };
    const std::vector<Gauge>& gauges = session.gauges().all();
    for (std::size_t i = 0; i < gauges.size(); ++i) {
        if (gauges[i].readings.empty()) continue;
        add({MarkKind::gauge, i}, {gauges[i].place_m, gauges[i].readings.back().level_m()}, yellow);
    }
    const std::vector<Spring>& springs = session.simulation().springs();
    const auto& heights_m = session.spring_heights().heights_m();
    for (std::size_t i = 0; i < std::min(springs.size(), heights_m.size()); ++i)
        if (heights_m[i]) add({MarkKind::spring, i}, {springs[i].x_m, springs[i].y_m, *heights_m[i]}, blue);
    const std::vector<PlacedSection>& sections = session.sections().all();
    for (std::size_t i = 0; i < sections.size(); ++i)
        if (const auto foot = picture.place(end_of(sections[i], false)))
            signs.push_back({*foot, fmt::format("S{}", i + 1)});
    std::sort(signs.begin(), signs.end(),
              [](const Sign& a, const Sign& b) { return a.foot.distance_m > b.foot.distance_m; });
    return signs;
}

void draw_sign(ImDrawList& list, const Sign& sign) {
    const ImVec2 at = sign.foot.at;
    list.AddLine(at, {at.x, at.y - 22}, dark, 2);
    list.AddCircleFilled({at.x, at.y - sign_height}, sign_radius, sign.colour);
    list.AddText({at.x - ImGui::CalcTextSize(sign.name.c_str()).x / 2, at.y - 35}, dark, sign.name.c_str());
}

// Places along the line between two points of the world.
std::vector<Place> along(const Picture& picture, glm::dvec3 begin, glm::dvec3 end) {
    constexpr int pieces = 48;
    std::vector<Place> places;
    places.reserve(pieces + 1);
    for (int i = 0; i <= pieces; ++i)
        if (const auto place = picture.place(glm::mix(begin, end, static_cast<double>(i) / pieces)))
            places.push_back(*place);
    return places;
}

// A path, at its height or that of the ground over it, in as many pieces as lie before the eye.
std::vector<std::vector<Place>> pieces_of(const Picture& picture, const PathDesign& design) {
    std::vector<std::vector<Place>> pieces(1);
    for (std::size_t i = 0; i < design.path.points_m.size(); ++i) {
        const glm::dvec3& point = design.path.points_m[i];
        const auto place = picture.place({glm::dvec2(point), std::max(point.z, design.ground_m[i])});
        if (place)
            pieces.back().push_back(*place);
        else if (!pieces.back().empty())
            pieces.emplace_back();
    }
    return pieces;
}

// The points of a path that is being drawn, on the ground.
std::vector<Place> dots_of(const PathDraft& path, const Picture& picture) {
    std::vector<Place> dots;
    for (std::size_t i = 0; i < std::min(path.points_m().size(), path.heights_m().size()); ++i)
        if (const auto place = picture.place({path.points_m()[i], path.heights_m()[i]}))
            dots.push_back(*place);
    return dots;
}

// The least box with room around each.
class Box {
  public:
    void add(ImVec2 at, float room) {
        low_ = glm::min(low_, glm::vec2(at.x, at.y) - room);
        high_ = glm::max(high_, glm::vec2(at.x, at.y) + room);
    }
    // Rows from below, within the window.
    gpu::Region region(glm::ivec2 window) const {
        const glm::ivec2 low = glm::clamp(glm::ivec2(glm::floor(low_)), glm::ivec2(0), window);
        const glm::ivec2 high = glm::clamp(glm::ivec2(glm::ceil(high_)), glm::ivec2(0), window);
        return {low.x, window.y - high.y, high.x - low.x, high.y - low.y};
    }

  private:
    glm::vec2 low_{1e6F};
    glm::vec2 high_{-1e6F};
};

}  // namespace

void Marks::hide_behind(double distance_m) {
    distances_m_.push_back(nearer * distance_m);
    ImGui::GetBackgroundDrawList()->AddCallback(
        [](const ImDrawList*, const ImDrawCmd* command) {
            render::GroundDepth::hide_behind(*static_cast<const double*>(command->UserCallbackData));
        },
        &distances_m_.back());
}

std::optional<MarkUnderMouse> Marks::under(glm::dvec2 mouse, const render::Camera& camera,
                                           const std::optional<glm::dvec3>& cursor) const {
    const double ground_m =
        cursor ? glm::distance(*cursor, camera.eye) : std::numeric_limits<double>::infinity();
    for (auto handle = handles_.rbegin(); handle != handles_.rend(); ++handle) {
        const glm::dvec2 from_middle = mouse - (handle->at - glm::dvec2(0, sign_height));
        const glm::dvec2 from_foot = mouse - handle->at;
        const bool near = glm::length(from_middle) <= sign_radius + 2 || glm::length(from_foot) <= 6;
        if (near && nearer * handle->distance_m <= ground_m) return MarkUnderMouse{handle->mark, -from_foot};
    }
    return std::nullopt;
}

void Marks::draw(Session& session, const PictureArea& area, glm::ivec2 drawn, glm::ivec2 window,
                 const Shown& shown) {
    const Picture picture(session.camera(), area);
    const std::vector<Sign> signs = signs_of(session, picture, shown.moved);
    handles_.clear();
    for (const Sign& sign : signs)
        if (sign.mark)
            handles_.push_back({*sign.mark, {sign.foot.at.x, sign.foot.at.y}, sign.foot.distance_m});
    std::vector<std::vector<Place>> lines;
    const auto& stroke = session.sculpting().stroke();
    if (stroke && stroke->name() == "ramp") lines.push_back(along(picture, stroke->begin(), stroke->at()));
    if (shown.drawn && shown.drawn->what != MapDrag::mask)
        lines.push_back(along(picture, shown.drawn->corners.first, shown.drawn->corners.second));
    if (shown.drawn && shown.drawn->what == MapDrag::mask) {
        const auto& [from, to] = shown.drawn->corners;
        // Between heights of what is clicked: the ground between is not known.
        const glm::dvec3 beside(to.x, from.y, (from.z + to.z) / 2);
        const glm::dvec3 before(from.x, to.y, (from.z + to.z) / 2);
        for (const auto& [begin, end] : {std::pair(from, beside), {beside, to}, {to, before}, {before, from}})
            lines.push_back(along(picture, begin, end));
    }
    for (const Event& event : session.simulation().events())
        if (shown.breaches && event.breach && !event.done)
            lines.push_back(along(picture, {event.breach->from_m, event.breach->crest_m},
                                  {event.breach->to_m, event.breach->crest_m}));
    for (const PlacedSection& one : session.sections().all())
        lines.push_back(along(picture, end_of(one, false), end_of(one, true)));
    if (shown.path && session.path_draft().design())
        for (std::vector<Place>& piece : pieces_of(picture, *session.path_draft().design()))
            lines.push_back(std::move(piece));
    const std::vector<Place> dots =
        shown.path ? dots_of(session.path_draft(), picture) : std::vector<Place>();
    // Behind the eye nothing is drawn.
    std::erase_if(lines, [](const std::vector<Place>& line) { return line.size() < 2; });
    if (signs.empty() && lines.empty() && dots.empty()) return;

    Box box;
    for (const Sign& sign : signs) box.add(sign.foot.at, 40);
    for (const std::vector<Place>& line : lines)
        for (const Place& place : line) box.add(place.at, 4);
    for (const Place& dot : dots) box.add(dot.at, 8);
    depth_.draw(session.hits(), drawn,
                {area.corner.x, window.y - area.corner.y - area.size.y, area.size.x, area.size.y},
                box.region(window));

    distances_m_.clear();
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    for (const std::vector<Place>& line : lines)
        for (std::size_t i = 1; i < line.size(); ++i) list.AddLine(line[i - 1].at, line[i].at, pale, 2);
    for (const std::vector<Place>& line : lines)
        for (std::size_t i = 1; i < line.size(); ++i) {
            hide_behind(std::min(line[i - 1].distance_m, line[i].distance_m));
            list.AddLine(line[i - 1].at, line[i].at, dark, 5);
            list.AddLine(line[i - 1].at, line[i].at, yellow, 2);
        }
    for (const Place& dot : dots) {
        hide_behind(dot.distance_m);
        list.AddCircleFilled(dot.at, 6, dark);
        list.AddCircleFilled(dot.at, 4.5F, yellow);
    }
    for (const Sign& sign : signs) {
        hide_behind(sign.foot.distance_m);
        draw_sign(list, sign);
    }
    list.AddCallback([](const ImDrawList*, const ImDrawCmd*) { render::GroundDepth::hide_nothing(); },
                     nullptr);
}

}  // namespace talus::app
