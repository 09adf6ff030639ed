#include <fmt/format.h>
#include <imgui.h>

#include "app/panels/panels.h"

namespace talus::app {
namespace {

// Where a point of the world is in the window; none: beside or behind the eye.
std::optional<ImVec2> in_window(const render::Camera& camera, const render::CameraRays& rays,
                                glm::dvec3 point, const PictureArea& area) {
    const std::optional<glm::dvec2> at = render::place_in_picture(camera, rays, point);
    if (!at) return std::nullopt;
    return ImVec2(static_cast<float>(area.corner.x + (0.5 + 0.5 * at->x) * area.size.x),
                  static_cast<float>(area.corner.y + (0.5 - 0.5 * at->y) * area.size.y));
}

constexpr ImU32 yellow = IM_COL32(250, 205, 60, 255);
constexpr ImU32 dark = IM_COL32(20, 24, 30, 255);

}  // namespace

void draw_marks(const Session& session, const PictureArea& area) {
    const render::Camera& camera = session.camera();
    const render::CameraRays rays = camera_rays(camera, area.size.x, area.size.y);
    ImDrawList* list = ImGui::GetBackgroundDrawList();
    const std::vector<Gauge>& gauges = session.gauges().all();
    for (std::size_t i = 0; i < gauges.size(); ++i) {
        if (gauges[i].readings.empty()) continue;
        const glm::dvec3 point(gauges[i].place_m, gauges[i].readings.back().level_m());
        const auto at = in_window(camera, rays, point, area);
        if (!at) continue;
        const std::string name = fmt::format("{}", i + 1);
        list->AddLine(*at, {at->x, at->y - 22}, dark, 2);
        list->AddCircleFilled({at->x, at->y - 28}, 9, yellow);
        list->AddText({at->x - 4, at->y - 35}, dark, name.c_str());
    }
    const auto& stroke = session.sculpting().stroke();
    if (!stroke || stroke->name() != "ramp") return;
    const auto begin = in_window(camera, rays, stroke->begin(), area);
    const auto end = in_window(camera, rays, stroke->at(), area);
    if (!begin || !end) return;
    list->AddLine(*begin, *end, dark, 5);
    list->AddLine(*begin, *end, yellow, 2);
}

}  // namespace talus::app
