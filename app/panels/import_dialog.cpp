#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "app/panels/panels.h"
#include "app/sources.h"
#include "sim/gpu/error.h"

namespace talus {
namespace {

constexpr int preview_side = 320;

// A small picture of heights, lit from the north-west.
std::vector<std::uint8_t> hillshade(const Heightmap& heightmap, glm::ivec2 size) {
    const Grid& grid = heightmap.grid;
    const auto [low, high] = std::minmax_element(heightmap.heights.begin(), heightmap.heights.end());
    const double relief = std::max(1e-6, static_cast<double>(*high) - *low);
    const glm::dvec2 step = glm::dvec2(grid.nx - 1, grid.ny - 1) / glm::dvec2(glm::max(size - 1, 1));
    const auto height = [&](int x, int y) {
        const int column = std::clamp(static_cast<int>(std::lround(x * step.x)), 0, grid.nx - 1);
        const int row = std::clamp(static_cast<int>(std::lround(y * step.y)), 0, grid.ny - 1);
        return static_cast<double>(heightmap.heights[static_cast<std::size_t>(row) * grid.nx + column]);
    };
    const glm::dvec3 sun = glm::normalize(glm::dvec3(-1, 1, 1.2));
    std::vector<std::uint8_t> rgba;
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x) {
            const double east = (height(x + 1, y) - height(x - 1, y)) / (2 * step.x * grid.dx);
            const double north = (height(x, y - 1) - height(x, y + 1)) / (2 * step.y * grid.dy);
            const double light = std::max(0.0, glm::dot(glm::normalize(glm::dvec3(-east, -north, 1)), sun));
            const double share = (height(x, y) - *low) / relief;
            for (const double tint : {0.55 + 0.45 * share, 0.60 + 0.35 * share, 0.50 + 0.45 * share})
                rgba.push_back(static_cast<std::uint8_t>(255 * std::clamp(light * 1.15 * tint, 0.0, 1.0)));
            rgba.push_back(255);
        }
    return rgba;
}

bool is_raw(const std::string& path) {
    const std::string ending = ending_of(path);
    return ending == ".raw" || ending == ".r16" || ending == ".r32";
}

void draw_settings(ImportDialog& dialog) {
    bool changed = false;
    ImGui::PushItemWidth(8 * ImGui::GetFontSize());
    ImGui::InputDouble("m a sample", &dialog.spacing_m, 0, 0, "%.6g");
    note_widget("import spacing");
    if (ImGui::IsItemDeactivatedAfterEdit() && dialog.spacing_m > 0) {
        dialog.settings.spacing_m = dialog.spacing_m;
        changed = true;
    }
    for (auto& [name, height] : {std::pair<const char*, double&>("m: the smallest value", dialog.low_m),
                                 std::pair<const char*, double&>("m: the largest value", dialog.high_m)}) {
        ImGui::InputDouble(name, &height, 0, 0, "%.6g");
        note_widget(name);
        if (!ImGui::IsItemDeactivatedAfterEdit() || !(dialog.high_m > dialog.low_m)) continue;
        dialog.settings.range_m = glm::dvec2(dialog.low_m, dialog.high_m);
        changed = true;
    }
    if (is_raw(dialog.path)) {
        ImGui::InputInt2("columns, rows", &dialog.raw_size.x);
        bool laid = ImGui::IsItemDeactivatedAfterEdit();
        laid = ImGui::Checkbox("big byte first", &dialog.big_endian) || laid;
        ImGui::SameLine();
        laid = ImGui::Checkbox("south row first", &dialog.south_first) || laid;
        if (laid && dialog.raw_size.x > 0 && dialog.raw_size.y > 0) {
            dialog.settings.raw =
                RawLayout{dialog.raw_size.x, dialog.raw_size.y, dialog.big_endian, dialog.south_first};
            changed = true;
        }
    }
    ImGui::PopItemWidth();
    if (changed) dialog.read(dialog.path);
}

}  // namespace

void ImportDialog::read(const std::string& file) {
    if (file != path) settings = {};
    path = file;
    error.clear();
    try {
        const Document document = open_document(file, settings);
        Heightmap heightmap;
        heightmap.grid = document.state.grid;
        heightmap.heights = document.state.ground();
        const auto [low, high] = std::minmax_element(heightmap.heights.begin(), heightmap.heights.end());
        samples = {heightmap.grid.nx, heightmap.grid.ny};
        spacing_m = heightmap.grid.dx;
        low_m = *low;
        high_m = *high;
        if (!settings.raw) raw_size = samples;
        notes = document.notes;
        kind = document.kind;
        crs.clear();
        if (document.state.georeference) {
            const std::string& wkt = document.state.georeference->wkt;
            const auto quote = wkt.find('"');
            crs =
                quote == std::string::npos ? "" : wkt.substr(quote + 1, wkt.find('"', quote + 1) - quote - 1);
        }
        const glm::dvec2 extent(heightmap.grid.width_m(), heightmap.grid.height_m());
        preview_size = glm::max(glm::ivec2(extent * (preview_side / std::max(extent.x, extent.y))), 2);
        preview = gpu::Texture("import preview", gpu::Format::rgba8, preview_size.x, preview_size.y);
        const std::vector<std::uint8_t> picture = hillshade(heightmap, preview_size);
        preview.write(preview.whole(), std::as_bytes(std::span(picture)));
    } catch (const std::exception& failed) {
        error = failed.what();
        preview = {};
    }
}

void draw_import_dialog(PanelContext& context) {
    ImportDialog& dialog = context.state.import;
    if (dialog.path.empty()) return;
    const float em = ImGui::GetFontSize();
    ImGui::OpenPopup("How the file is read");
    ImGui::SetNextWindowSize({48 * em, 0});
    ImGui::SetNextWindowPos(ImGui::GetMainViewport()->GetCenter(), ImGuiCond_Always, {0.5F, 0.5F});
    if (!ImGui::BeginPopupModal("How the file is read", nullptr,
                                ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize))
        return;
    text_line(dialog.path);
    const float side = 20 * em;
    ImGui::BeginChild("preview", {side + em, side + em});
    if (dialog.preview.width() > 0) {
        const float scale = side / static_cast<float>(std::max(dialog.preview_size.x, dialog.preview_size.y));
        ImGui::Image(panel_image(dialog.preview), {scale * static_cast<float>(dialog.preview_size.x),
                                                   scale * static_cast<float>(dialog.preview_size.y)});
    }
    ImGui::EndChild();
    ImGui::SameLine();
    ImGui::BeginChild("settings", {0, side + em});
    ImGui::PushTextWrapPos(0);
    if (dialog.error.empty()) {
        ImGui::TextUnformatted(
            fmt::format("{}, {} × {} samples", dialog.kind, dialog.samples.x, dialog.samples.y).c_str());
        if (!dialog.crs.empty()) ImGui::TextUnformatted(dialog.crs.c_str());
        for (const std::string& note : dialog.notes) {
            ImGui::Bullet();
            ImGui::TextUnformatted(note.c_str());
        }
    } else {
        ImGui::TextColored({1, 0.7F, 0.3F, 1}, "%s", dialog.error.c_str());
    }
    ImGui::PopTextWrapPos();
    ImGui::Spacing();
    draw_settings(dialog);
    ImGui::EndChild();
    const bool good = dialog.error.empty();
    bool ended = false;
    if (button("Open it", "as a scene of its own", good)) {
        SceneRequest request;
        request.input = dialog.path;
        request.import = dialog.settings;
        context.requests.open = request;
        context.state.start_page = false;
        ended = true;
    }
    ImGui::SameLine();
    if (button("Import it", "in place of this terrain, as an act that can be undone; settings go on", good)) {
        context.requests.acts.emplace_back([path = dialog.path, settings = dialog.settings](Session& s) {
            s.apply(read_import(path, settings));
        });
        ended = true;
    }
    ImGui::SameLine();
    if (button("Cancel import") || ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape))) ended = true;
    if (ended) {
        dialog.path.clear();
        ImGui::CloseCurrentPopup();
    }
    ImGui::EndPopup();
}

}  // namespace talus
