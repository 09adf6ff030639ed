#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

#include "app/panels/panels.h"
#include "sim/drives.h"
#include "sim/terrain/painted_numbers.h"

namespace talus::app {
namespace {

constexpr int plotted_places = 256;

void offer_numbers(PanelContext& context, bool within_tick) {
    std::string& chosen = context.state.table_of;
    for (const Parameter& p : context.session.simulation().parameters().declared()) {
        if (!can_be_driven(p) || (p.driven == Driven::within_tick) != within_tick) continue;
        if (ImGui::Selectable(shown_name(p).c_str(), p.name == chosen)) chosen = p.name;
        note_widget("follow " + p.name);
        if (p.name == chosen) ImGui::SetItemDefaultFocus();
        tooltip_of(p.help);
    }
}

void choose_number(PanelContext& context) {
    ImGui::SetNextItemWidth(-1);
    const Parameter& chosen = context.session.declaration(context.state.table_of);
    const bool open = ImGui::BeginCombo("##number", shown_name(chosen).c_str(), ImGuiComboFlags_HeightLarge);
    note_widget("number that follows");
    if (!open) return;
    close_on_escape();
    // What tables are mostly of comes first.
    offer_numbers(context, true);
    ImGui::Separator();
    offer_numbers(context, false);
    ImGui::EndCombo();
}

// The table at even times from its first row to its last, and behind each the lowest and the highest row
// before the next, so that no peak is missed.
std::vector<float> plotted(const TimeSeries& series) {
    const std::vector<TimeSeries::Row>& rows = series.rows();
    const double first_s = rows.front().time_s;
    const double step_s = (rows.back().time_s - first_s) / plotted_places;
    std::vector<float> values;
    values.reserve(3 * plotted_places + 1);
    std::size_t row = 0;
    for (int i = 0; i < plotted_places; ++i) {
        double low = series.at(first_s + step_s * i);
        double high = low;
        values.push_back(static_cast<float>(low));
        const bool last = i == plotted_places - 1;
        for (; row < rows.size() && (last || rows[row].time_s < first_s + step_s * (i + 1)); ++row) {
            low = std::min(low, rows[row].value);
            high = std::max(high, rows[row].value);
        }
        values.push_back(static_cast<float>(low));
        values.push_back(static_cast<float>(high));
    }
    values.push_back(static_cast<float>(rows.back().value));
    return values;
}

void draw_table(PanelContext& context, const Drive& drive) {
    const Session& session = context.session;
    const Parameter& p = session.declaration(drive.parameter);
    const std::vector<TimeSeries::Row>& rows = drive.series.rows();
    const double now_s = session.simulation().clock().simulated_s;
    ImGui::PushID(drive.parameter.c_str());
    heading(shown_name(p).c_str());
    figure_line("now", fmt::format("{} {}", figure(drive.series.at(now_s), 4), p.unit));
    figure_line("table", fmt::format("{} rows, {} to {} s", rows.size(), figure(rows.front().time_s, 6),
                                     figure(rows.back().time_s, 6)));
    const double first_s = rows.front().time_s;
    const double span_s = rows.back().time_s - first_s;
    TablePlot& plot = context.state.table_plots[drive.parameter];
    if (!(plot.of == drive.series)) plot = {drive.series, plotted(drive.series)};
    plot_line("last row", plot.values, p.unit.c_str());
    if (span_s > 0 && now_s >= first_s && now_s <= first_s + span_s) {
        // Plots lie within the frame's padding.
        const float low = ImGui::GetItemRectMin().x + ImGui::GetStyle().FramePadding.x;
        const float high = ImGui::GetItemRectMax().x - ImGui::GetStyle().FramePadding.x;
        const float x = low + static_cast<float>((now_s - first_s) / span_s) * (high - low);
        ImGui::GetWindowDrawList()->AddLine({x, ImGui::GetItemRectMin().y}, {x, ImGui::GetItemRectMax().y},
                                            ImGui::GetColorU32(ImGuiCol_Text));
    }
    if (button("End it", "the number goes on as if it were set now; a wave by its table ends"))
        context.requests.acts.emplace_back([name = drive.parameter](Session& s) {
            s.apply(DriveParameter{name, {}});
        });
    note_widget("end table of " + drive.parameter);
    ImGui::PopID();
}

// A raster in place of what a brush would paint.
void draw_rasters(PanelContext& context) {
    heading("What differs from place to place");
    ImGui::TextWrapped(
        "What brushes paint can also come from a raster (GeoTIFF and others): where both say where they lie, "
        "it is laid there, else it is stretched over the terrain.");
    const PaintedNumberDescription& chosen = painted_number_named(context.state.raster_of);
    ImGui::SetNextItemWidth(-1);
    const bool open = ImGui::BeginCombo("##painted", chosen.title.c_str(), ImGuiComboFlags_HeightLarge);
    note_widget("number of the raster");
    if (open) {
        close_on_escape();
        for (const PaintedNumberDescription& number : painted_numbers()) {
            if (ImGui::Selectable(number.title.c_str(), number.name == chosen.name))
                context.state.raster_of = number.name;
            note_widget("raster of " + number.name);
        }
        ImGui::EndCombo();
    }
    if (button("Choose a raster…", "a file with one number a pixel, in the unit that the number has here"))
        context.state.dialog.begin(FileDialog::Purpose::raster, context.session.path());
}

}  // namespace

void draw_tables_panel(PanelContext& context) {
    ImGui::TextWrapped(
        "A number of the simulation can follow a table against simulated time: a text file (CSV) with rows "
        "of "
        "time in seconds and value, linear between them.");
    heading("Number");
    choose_number(context);
    ImGui::Checkbox("the table's 0 s is now", &context.state.table_begins_now);
    note_widget("table begins now");
    if (button("Choose a table…", "a file of rows such as 600,12.5"))
        context.state.dialog.begin(FileDialog::Purpose::table, context.session.path());
    for (const Drive& drive : context.session.simulation().drives()) draw_table(context, drive);
    draw_rasters(context);
    draw_events(context);
}

}  // namespace talus::app
