#include <fmt/format.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include "app/panels/panels.h"
#include "sim/gpu/error.h"

namespace talus {

void ImportPanel::follow(const Session& session) {
    shown = true;
    spacing_m = session.grid().dx;
    low_m = session.bounds().x;
    high_m = session.bounds().y;
    raw.clear();
}

void draw_import_panel(const Session& session, ImportPanel& panel, PanelRequests& requests) {
    const std::vector<std::string>& notes = session.scene().document.notes;
    if (!panel.shown || notes.empty()) return;
    ImGui::SetNextWindowPos({360, 10}, ImGuiCond_FirstUseEver);
    ImGui::SetNextWindowSize({600, 0}, ImGuiCond_FirstUseEver);
    if (ImGui::Begin("How the file was read", &panel.shown)) {
        for (const std::string& note : notes) {
            ImGui::Bullet();
            ImGui::TextWrapped("%s", note.c_str());
        }
        const std::string input = session.request().input;
        ImGui::PushItemWidth(120);
        ImGui::InputDouble("m a sample", &panel.spacing_m, 0, 0, "%.6g");
        ImGui::SameLine();
        if (ImGui::Button("Read again with this spacing"))
            requests.acts.emplace_back([input, spacing_m = panel.spacing_m](Session& s) {
                ImportSettings import = s.request().import;
                import.spacing_m = spacing_m;
                s.open(input, import);
            });
        ImGui::InputDouble("to", &panel.low_m, 0, 0, "%.6g");
        ImGui::SameLine();
        ImGui::InputDouble("m of height", &panel.high_m, 0, 0, "%.6g");
        ImGui::SameLine();
        if (ImGui::Button("Read again with this range"))
            requests.acts.emplace_back([input, low_m = panel.low_m, high_m = panel.high_m](Session& s) {
                if (!(high_m > low_m)) throw Error("the range's first height must be the lower one");
                ImportSettings import = s.request().import;
                import.range_m = glm::dvec2(low_m, high_m);
                s.open(input, import);
            });
        if (ending_of(input) == ".raw" || ending_of(input) == ".r16" || ending_of(input) == ".r32") {
            ImGui::InputText("NXxNY[,big][,bottom]", &panel.raw);
            ImGui::SameLine();
            if (ImGui::Button("Read again with this layout"))
                requests.acts.emplace_back([input, raw = panel.raw](Session& s) {
                    ImportSettings import = s.request().import;
                    import.raw = parse_raw_layout(raw);
                    s.open(input, import);
                });
        }
        ImGui::PopItemWidth();
    }
    ImGui::End();
}

}  // namespace talus
