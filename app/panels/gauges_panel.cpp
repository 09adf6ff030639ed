#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

#include "app/panels/panels.h"
#include "sim/io/atomic_file.h"

namespace talus::app {
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

void draw_gauges_panel(PanelContext& context) {
    const Session& session = context.session;
    PanelRequests& requests = context.requests;
    bool& placing = context.state.placing_gauge;
    if (button(placing ? "Click on the map…" : "Place a gauge", "by the next click on the ground"))
        placing = !placing;
    const std::vector<Gauge>& gauges = session.gauges().all();
    if (!gauges.empty()) {
        ImGui::SameLine();
        if (button("Save as gauges.csv", "in the folder where Talus was started"))
            requests.acts.emplace_back(
                [](Session& s) { io::write_atomically("gauges.csv", s.gauges().to_csv()); });
    }
    for (std::size_t i = 0; i < gauges.size(); ++i) {
        ImGui::PushID(static_cast<int>(i));
        const Gauge& gauge = gauges[i];
        ImGui::TextWrapped("Gauge %zu at %.0f, %.0f m", i + 1, gauge.place_m.x, gauge.place_m.y);
        const bool removed = ImGui::SmallButton("remove");
        note_widget(fmt::format("remove gauge {}", i + 1));
        if (removed) requests.acts.emplace_back([i](Session& s) { s.gauges().remove(i); });
        plot_line("level", plotted(gauge, [](const GaugeReading& r) { return r.level_m(); }), "m");
        plot_line("speed",
                  plotted(gauge, [](const GaugeReading& r) { return glm::length(r.velocity_m_per_s); }),
                  "m/s");
        ImGui::PopID();
    }
}

}  // namespace talus::app
