#include "app/panels/marks.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

namespace talus::app {
namespace {

constexpr ImU32 yellow = IM_COL32(250, 205, 60, 255);
constexpr ImU32 dark = IM_COL32(20, 24, 30, 255);
constexpr ImU32 pale = IM_COL32(250, 205, 60, 110);

// What stands on the ground is as far away as that: it shows.
constexpr double nearer = 0.997;

// Where a point of the world is in the window.
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
                     glm::distance(point, camera_.eye)};
    }

  private:
    render::Camera camera_;
    render::CameraRays rays_;
    PictureArea area_;
};

struct Sign {
    Place foot;
    std::string name;
};

// The farthest first.
std::vector<Sign> signs_of(const Session& session, const Picture& picture) {
    std::vector<Sign> signs;
    const std::vector<Gauge>& gauges = session.gauges().all();
    for (std::size_t i = 0; i < gauges.size(); ++i) {
        if (gauges[i].readings.empty()) continue;
        const auto foot = picture.place({gauges[i].place_m, gauges[i].readings.back().level_m()});
        if (foot) signs.push_back({*foot, fmt::format("{}", i + 1)});
    }
    std::sort(signs.begin(), signs.end(),
              [](const Sign& a, const Sign& b) { return a.foot.distance_m > b.foot.distance_m; });
    return signs;
}

void draw_sign(ImDrawList& list, const Sign& sign) {
    const ImVec2 at = sign.foot.at;
    list.AddLine(at, {at.x, at.y - 22}, dark, 2);
    list.AddCircleFilled({at.x, at.y - 28}, 9, yellow);
    list.AddText({at.x - 4, at.y - 35}, dark, sign.name.c_str());
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

void Marks::draw(Session& session, const PictureArea& area, glm::ivec2 drawn, glm::ivec2 window) {
    const Picture picture(session.camera(), area);
    const std::vector<Sign> signs = signs_of(session, picture);
    std::vector<Place> ramp;
    const auto& stroke = session.sculpting().stroke();
    if (stroke && stroke->name() == "ramp") ramp = along(picture, stroke->begin(), stroke->at());
    if (signs.empty() && ramp.empty()) return;

    Box box;
    for (const Sign& sign : signs) box.add(sign.foot.at, 40);
    for (const Place& place : ramp) box.add(place.at, 4);
    depth_.draw(session.hits(), drawn,
                {area.corner.x, window.y - area.corner.y - area.size.y, area.size.x, area.size.y},
                box.region(window));

    distances_m_.clear();
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    for (std::size_t i = 1; i < ramp.size(); ++i) list.AddLine(ramp[i - 1].at, ramp[i].at, pale, 2);
    for (std::size_t i = 1; i < ramp.size(); ++i) {
        hide_behind(std::min(ramp[i - 1].distance_m, ramp[i].distance_m));
        list.AddLine(ramp[i - 1].at, ramp[i].at, dark, 5);
        list.AddLine(ramp[i - 1].at, ramp[i].at, yellow, 2);
    }
    for (const Sign& sign : signs) {
        hide_behind(sign.foot.distance_m);
        draw_sign(list, sign);
    }
    list.AddCallback([](const ImDrawList*, const ImDrawCmd*) { render::GroundDepth::hide_nothing(); },
                     nullptr);
}

}  // namespace talus::app
