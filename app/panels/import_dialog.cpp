#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "app/panels/panels.h"
#include "sim/error.h"
#include "sim/io/heightmap_formats.h"

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
    const HeightmapFormat* format = format_of(path);
    return format && format->headerless;
}

// Whether they are others now.
bool draw_settings(ImportDialog& dialog) {
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
    return changed;
}

}  // namespace

ImportPreview preview_of(const ImportWish& wish) {
    ImportPreview found;
    found.wish = wish;
    try {
        const Document document = open_document(wish.path, wish.settings);
        Heightmap heightmap;
        heightmap.grid = found.grid = document.state.grid;
        heightmap.heights = document.state.ground();
        const auto [low, high] = std::minmax_element(heightmap.heights.begin(), heightmap.heights.end());
        found.low_m = *low;
        found.high_m = *high;
        found.notes = document.notes;
        found.kind = document.kind;
        if (document.state.georeference) {
            const std::string& wkt = document.state.georeference->wkt;
            const auto quote = wkt.find('"');
            found.crs =
                quote == std::string::npos ? "" : wkt.substr(quote + 1, wkt.find('"', quote + 1) - quote - 1);
        }
        const glm::dvec2 extent(heightmap.grid.width_m(), heightmap.grid.height_m());
        found.picture_size = glm::max(glm::ivec2(extent * (preview_side / std::max(extent.x, extent.y))), 2);
        found.picture = hillshade(heightmap, found.picture_size);
    } catch (const std::exception& failed) {
        found.error = failed.what();
    }
    return found;
}

void ImportDialog::show(const ImportPreview& found) {
    path = found.wish.path;
    settings = found.wish.settings;
    error = found.error;
    preview = {};
    if (!error.empty()) return;
    samples = {found.grid.nx, found.grid.ny};
    spacing_m = found.grid.dx;
    low_m = found.low_m;
    high_m = found.high_m;
    if (!settings.raw) raw_size = samples;
    notes = found.notes;
    kind = found.kind;
    crs = found.crs;
    preview_size = found.picture_size;
    preview = gpu::Texture("import preview", gpu::Format::rgba8, preview_size.x, preview_size.y);
    preview.write(preview.whole(), std::as_bytes(std::span(found.picture)));
}

void draw_import_dialog(PanelContext& context) {
    ImportDialog& dialog = context.state.import;
    if (dialog.path.empty()) return;
    const float em = ImGui::GetFontSize();
    if (!begin_dialog("How the file is read", 48)) return;
    // While it is read again, what it shows is of the settings before.
    const bool waits = context.work.busy();
    ImGui::BeginDisabled(waits);
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
    // It is read again on a thread, and shown between two frames: this one still draws the picture before.
    if (draw_settings(dialog)) context.requests.look_at = {dialog.path, dialog.settings};
    ImGui::EndChild();
    ImGui::EndDisabled();
    // What is pressed while the file is read again is done when that has ended.
    const bool good = dialog.error.empty();
    if (button("Open it", "as a scene of its own", good)) dialog.then = ImportDialog::Then::open;
    ImGui::SameLine();
    if (button("Import it", "in place of this terrain, as an act that can be undone; settings go on", good))
        dialog.then = ImportDialog::Then::import_here;
    if (!good) dialog.then = ImportDialog::Then::stay;
    bool ended = false;
    if (!waits && !context.requests.look_at && dialog.then != ImportDialog::Then::stay) {
        if (dialog.then == ImportDialog::Then::open) {
            SceneRequest request;
            request.input = dialog.path;
            request.import = dialog.settings;
            context.requests.open = request;
            context.state.start_page = false;
        } else {
            context.requests.import_here = {dialog.path, dialog.settings};
        }
        ended = true;
    }
    ImGui::SameLine();
    // While it is read again, that is given up, and what was to be done with it.
    if (button("Cancel import") || ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape))) {
        dialog.then = ImportDialog::Then::stay;
        if (waits)
            context.requests.cancel_work = true;
        else
            ended = true;
    }
    if (ended) {
        dialog.then = ImportDialog::Then::stay;
        dialog.path.clear();
        ImGui::CloseCurrentPopup();
    }
    ImGui::EndPopup();
}

}  // namespace talus
