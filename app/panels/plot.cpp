#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

#include "app/panels/panels.h"

namespace talus {

void plot_line(const char* label, const std::vector<float>& values, const char* unit) {
    if (values.empty()) return;
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    const std::string text =
        fmt::format("{} {:.4g} {}  ({:.4g} to {:.4g})", label, values.back(), unit, *low, *high);
    ImGui::TextUnformatted(text.c_str());
    // A line that does not move lies in the middle, not at an edge.
    const float room = std::max(0.05F * (*high - *low), 1e-6F);
    ImGui::PlotLines(fmt::format("##{}", label).c_str(), values.data(), static_cast<int>(values.size()), 0,
                     nullptr, *low - room, *high + room, {300, 44});
}

}  // namespace talus
