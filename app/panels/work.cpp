#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "app/core/long_work.h"
#include "app/panels/panels.h"

namespace talus::app {

void draw_work(const Work& work, bool& cancelled) {
    // What is short needs no bar.
    if (!work.busy() || work.seconds() < 0.3) return;
    const ImVec2 middle = ImGui::GetMainViewport()->GetCenter();
    ImGui::SetNextWindowPos(middle, ImGuiCond_Always, {0.5F, 0.5F});
    ImGui::SetNextWindowSize({24 * ImGui::GetFontSize(), 0});
    ImGui::Begin("Work", nullptr,
                 ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize);
    text_line(work.name());
    const std::optional<double> share = work.share();
    // Where the progress is unknown the bar shows that the work goes on.
    const double length = share.value_or(work.seconds() - std::floor(work.seconds()));
    const std::string left = share ? fmt::format("{:.0f} %, ", 100 * *share) : "";
    ImGui::ProgressBar(static_cast<float>(length), {-1, 0},
                       fmt::format("{}{:.0f} s", left, work.seconds()).c_str());
    cancelled = button("Cancel work", "everything stays as it was", work.can_cancel());
    ImGui::End();
}

void draw_preparation(const Work& work, const PictureArea& area, bool& stopped) {
    if (!work.busy()) return;
    const auto middle = static_cast<float>(area.corner.x) + static_cast<float>(area.size.x) / 2;
    const auto bottom = static_cast<float>(area.corner.y + area.size.y) - 0.8F * ImGui::GetFontSize();
    ImGui::SetNextWindowPos({middle, bottom}, ImGuiCond_Always, {0.5F, 1});
    ImGui::SetNextWindowSize({std::min(24 * ImGui::GetFontSize(), static_cast<float>(area.size.x)), 0});
    ImGui::Begin(
        "Preparation", nullptr,
        ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoFocusOnAppearing);
    text_line(work.name());
    const double share = work.share().value_or(0);
    const float room = ImGui::CalcTextSize("Stop").x + 4 * ImGui::GetStyle().FramePadding.x;
    ImGui::ProgressBar(static_cast<float>(share), {-room - ImGui::GetStyle().ItemSpacing.x, 0},
                       share_and_time_left(share, work.seconds()).c_str());
    ImGui::SameLine();
    stopped = button("Stop", "what is shown stays as it is");
    ImGui::End();
}

}  // namespace talus::app
