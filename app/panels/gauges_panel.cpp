#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

#include "app/panels/panels.h"
#include "sim/io/atomic_file.h"

namespace talus::app {
namespace {

// The values of so many rows as a plot has room for, one of several where there are more.
template <typename Value>
std::vector<float> plotted(std::size_t rows, Value value) {
    constexpr std::size_t room = 512;
    const std::size_t stride = rows / room + 1;
    std::vector<float> values;
    values.reserve(rows / stride + 1);
    for (std::size_t i = 0; i < rows; i += stride) values.push_back(static_cast<float>(value(i)));
    return values;
}

void draw_gauges(PanelContext& context) {
    const Session& session = context.session;
    PanelRequests& requests = context.requests;
    place_button(context.state, MarkKind::gauge, "Place a gauge");
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
        ImGui::TextUnformatted(fmt::format("Gauge {}", i + 1).c_str());
        ImGui::SameLine();
        const bool removed = ImGui::SmallButton("remove");
        note_widget(fmt::format("remove gauge {}", i + 1));
        if (removed) requests.acts.emplace_back([i](Session& s) { s.gauges().remove(i); });
        if (const auto to = place_fields(context, fmt::format("gauge {}", i + 1), gauge.place_m))
            requests.acts.emplace_back([i, at = *to](Session& s) { s.gauges().move(i, at); });
        const std::vector<GaugeReading>& readings = gauge.readings;
        plot_line("level", plotted(readings.size(), [&](std::size_t at) { return readings[at].level_m(); }),
                  "m");
        plot_line("speed",
                  plotted(readings.size(),
                          [&](std::size_t at) { return glm::length(readings[at].velocity_m_per_s); }),
                  "m/s");
        ImGui::PopID();
    }
}

void draw_sections(PanelContext& context) {
    const Session& session = context.session;
    PanelRequests& requests = context.requests;
    heading("Sections");
    draw_button(
        context.state, MapDrag::section, "Draw a section",
        "a line through which the water is counted: press where it begins, let go where it ends; to the "
        "right of one who looks that way counts as positive");
    const Sections& sections = session.sections();
    if (!sections.all().empty()) {
        ImGui::SameLine();
        if (button("Save as sections.csv", "in the folder where Talus was started"))
            requests.acts.emplace_back(
                [](const Session& s) { io::write_atomically("sections.csv", s.sections().to_csv()); });
    }
    for (std::size_t i = 0; i < sections.all().size(); ++i) {
        const PlacedSection& one = sections.all()[i];
        ImGui::PushID(static_cast<int>(1000 + i));
        ImGui::TextWrapped("%s", fmt::format("Section S{} from {:.0f}, {:.0f} to {:.0f}, {:.0f} m", i + 1,
                                             one.section.from_m.x, one.section.from_m.y, one.section.to_m.x,
                                             one.section.to_m.y)
                                     .c_str());
        const bool removed = ImGui::SmallButton("remove");
        note_widget(fmt::format("remove section {}", i + 1));
        if (removed) requests.acts.emplace_back([i](Session& s) { s.remove_section(i); });
        const std::size_t rows = one.volumes_m3.size();
        plot_line(
            "discharge",
            plotted(rows,
                    [&](std::size_t row) { return sections.discharge_m3_per_s(one, one.first_row + row); }),
            "m³/s");
        plot_line("volume", plotted(rows, [&](std::size_t row) { return one.volumes_m3[row]; }), "m³");
        ImGui::PopID();
    }
}

}  // namespace

void draw_gauges_panel(PanelContext& context) {
    draw_gauges(context);
    draw_sections(context);
}

}  // namespace talus::app
