#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

#include "app/panels/panels.h"
#include "sim/io/atomic_file.h"

namespace talus {
namespace {

// As many of a gauge's last readings as a plot has room for, one of several where there are more.
template <typename Value>
std::vector<float> plotted(const Gauge& gauge, Value value) {
    constexpr std::size_t room = 512;
    const std::size_t stride = gauge.readings.size() / room + 1;
    std::vector<float> values;
    values.reserve(gauge.readings.size() / stride + 1);
    for (std::size_t i = 0; i < gauge.readings.size(); i += stride)
        values.push_back(static_cast<float>(value(gauge.readings[i])));
    return values;
}

}  // namespace

void draw_gauges_panel(Session& session, bool& placing, PanelRequests& requests) {
    if (ImGui::Button(placing ? "Click on the map…" : "Place a gauge")) placing = !placing;
    const std::vector<Gauge>& gauges = session.gauges().all();
    if (!gauges.empty()) {
        ImGui::SameLine();
        if (ImGui::Button("Save as gauges.csv"))
            requests.acts.emplace_back(
                [](Session& s) { write_atomically("gauges.csv", s.gauges().to_csv()); });
    }
    for (std::size_t i = 0; i < gauges.size(); ++i) {
        ImGui::PushID(static_cast<int>(i));
        const Gauge& gauge = gauges[i];
        ImGui::Text("Gauge %zu at %.0f, %.0f m", i + 1, gauge.place_m.x, gauge.place_m.y);
        ImGui::SameLine();
        if (ImGui::SmallButton("remove"))
            requests.acts.emplace_back([i](Session& s) { s.gauges().remove(i); });
        plot_line("level", plotted(gauge, [](const GaugeReading& r) { return r.level_m(); }), "m");
        plot_line("speed",
                  plotted(gauge, [](const GaugeReading& r) { return glm::length(r.velocity_m_per_s); }),
                  "m/s");
        ImGui::PopID();
    }
}

void draw_gauge_marks(const Session& session, int width, int height) {
    const Camera& camera = session.camera();
    const CameraRays rays = camera_rays(camera, width, height);
    ImDrawList* list = ImGui::GetBackgroundDrawList();
    const std::vector<Gauge>& gauges = session.gauges().all();
    for (std::size_t i = 0; i < gauges.size(); ++i) {
        if (gauges[i].readings.empty()) continue;
        const glm::dvec3 point(gauges[i].place_m, gauges[i].readings.back().level_m());
        const glm::dvec3 from_eye = point - camera.eye;
        const double depth = glm::dot(from_eye, rays.forward);
        if (depth <= 0) continue;
        const glm::dvec3 aside = from_eye / depth - rays.middle;
        const double x = glm::dot(aside, rays.right) / glm::dot(rays.right, rays.right);
        const double y = glm::dot(aside, rays.up) / glm::dot(rays.up, rays.up);
        const ImVec2 at(static_cast<float>((0.5 + 0.5 * x) * width),
                        static_cast<float>((0.5 - 0.5 * y) * height));
        const std::string name = fmt::format("{}", i + 1);
        list->AddLine(at, {at.x, at.y - 22}, IM_COL32(20, 24, 30, 255), 2);
        list->AddCircleFilled({at.x, at.y - 28}, 9, IM_COL32(250, 205, 60, 255));
        list->AddText({at.x - 4, at.y - 35}, IM_COL32(20, 24, 30, 255), name.c_str());
    }
}

}  // namespace talus
