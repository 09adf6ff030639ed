#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

#include "app/panels/panels.h"

namespace talus::app {

namespace {

// Of the terrain or of a photo.
template <typename Paged>
void tile_figures(const Paged& tiles, int slots, std::size_t bytes) {
    figure_line("drawn", fmt::format("{}", tiles.drawn_tiles()));
    figure_line("on their way", fmt::format("{}", tiles.awaited_tiles()));
    figure_line("there is room for", fmt::format("{}", slots));
    figure_line("memory of the device", fmt::format("{:.1f} MiB", static_cast<double>(bytes) / (1 << 20)));
}

}  // namespace

void draw_profiler_panel(PanelContext& context) {
    Session& session = context.session;
    if (!context.state.only_looks) {
        session.follow_activity();
        const Activity::Counts& activity = session.activity();
        heading("Tiles that are active");
        const int all = session.simulation().terrain().tiles.count();
        figure_line("slopes", fmt::format("{} of {}", activity.slope_tiles, all));
        figure_line("water", fmt::format("{} of {}", activity.water_tiles, all));
        figure_line("a tick", fmt::format("{:.2f} ms", session.tick_ms()));
    }
    if (const PagedTiles* tiles = session.tiles()) {
        heading("Tiles of the picture");
        tile_figures(*tiles, tiles->surface().slots(), tiles->surface().bytes());
    }
    if (const PagedPhoto* photo = session.photo()) {
        heading("Tiles of the photo");
        tile_figures(*photo, photo->surface().slots(), photo->surface().bytes());
    }
    heading("Passes, ms a second");
    if (context.state.passes_s <= 0) return;
    std::vector<gpu::PassTime> passes = context.state.passes;
    std::sort(passes.begin(), passes.end(),
              [](const gpu::PassTime& a, const gpu::PassTime& b) { return a.device_ms > b.device_ms; });
    if (!ImGui::BeginTable("passes", 4, ImGuiTableFlags_SizingStretchProp | ImGuiTableFlags_RowBg)) return;
    for (const char* column : {"pass", "calls", "CPU", "GPU"}) ImGui::TableSetupColumn(column);
    ImGui::TableHeadersRow();
    const double a_second = 1 / context.state.passes_s;
    for (const gpu::PassTime& pass : passes) {
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        text_line(pass.name);
        for (const std::string& figure :
             {fmt::format("{:.0f}", pass.calls * a_second), fmt::format("{:.1f}", pass.cpu_ms * a_second),
              fmt::format("{:.1f}", pass.device_ms * a_second)}) {
            ImGui::TableNextColumn();
            ImGui::TextUnformatted(figure.c_str());
        }
    }
    ImGui::EndTable();
}

}  // namespace talus::app
