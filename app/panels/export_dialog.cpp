#include <fmt/format.h>
#include <fmt/ranges.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <array>
#include <filesystem>

#include "app/panels/panels.h"
#include "app/panels/style.h"
#include "sim/io/endings.h"
#include "sim/io/heightmap_formats.h"
#include "sim/terrain/layers.h"

namespace talus::app {
namespace {

const char* usual_ending(io::ExportKind kind) {
    switch (kind) {
        case io::ExportKind::mesh:
            return ".glb";
        case io::ExportKind::normal_map:
        case io::ExportKind::maps:
        case io::ExportKind::unreal:
            return ".png";
        case io::ExportKind::unity:
            return ".raw";
        case io::ExportKind::godot:
            return ".r16";
        default:
            return ".tif";
    }
}

// "GeoTIFF (tif, tiff), EXR (exr)" and so on: lines break before dots.
std::string formats_written() {
    std::vector<std::string> texts;
    for (const io::HeightmapFormat& format : io::heightmap_formats()) {
        std::vector<std::string> endings;
        for (const std::string& ending : format.endings) endings.push_back(ending.substr(1));
        if (format.write) texts.push_back(fmt::format("{} ({})", format.name, fmt::join(endings, ", ")));
    }
    return fmt::format("{}", fmt::join(texts, ", "));
}

std::string what_it_is(io::ExportKind kind) {
    switch (kind) {
        case io::ExportKind::mesh:
            return "Triangles, simplified within the error below, with normals and texture coordinates: "
                   "Wavefront OBJ (.obj), glTF (.glb, .gltf).";
        case io::ExportKind::normal_map:
            return "PNG, 16 bits: red east, green north, blue up.";
        case io::ExportKind::maps:
            return "Maps for texturing, each in a file of its own, and what their values mean in a .json: " +
                   formats_written() + ".";
        case io::ExportKind::unreal:
            return "A landscape's heightmap: .png or .r16, and what to type there in a .txt beside it.";
        case io::ExportKind::unity:
            return "A terrain's RAW: .raw or .r16, and what to type there in a .txt beside it.";
        case io::ExportKind::godot:
            return "For Terrain3D: .r16 or .exr, and what to type there in a .txt beside it.";
        default:
            return "A heightmap: " + formats_written() +
                   ". Files that cannot hold spacing and heights get a .json beside them, which Talus reads "
                   "too.";
    }
}

// Reads the terrain once, and looks at it anew when the settings change.
void follow_losses(const Session& session, ExportDialog& dialog) {
    io::ExportSettings settings = dialog.settings;
    settings.path = io::with_ending(settings.path, usual_ending(settings.kind));
    const std::string with = fmt::format("{} {} {} {} {} {} {}", static_cast<int>(settings.kind),
                                         settings.path.string(), settings.tiles.x, settings.tiles.y,
                                         settings.range_m ? settings.range_m->x + 7 * settings.range_m->y : 0,
                                         settings.layer, settings.weight_bits);
    if (!dialog.state) dialog.state = session.simulation().read();
    if (dialog.lost_with == with) return;
    dialog.lost_with = with;
    dialog.lost = io::losses(*dialog.state, settings);
}

// One of several, by its place among them. `open`: becomes true while its list is; Escape is the list's then.
int choose(const char* name, const std::vector<std::string>& choices, int chosen, bool& open) {
    label_before(label_of_name(name));
    if (ImGui::BeginCombo((std::string("##") + name).c_str(),
                          choices[static_cast<std::size_t>(chosen)].c_str())) {
        open = true;
        close_on_escape();
        for (std::size_t i = 0; i < choices.size(); ++i)
            if (ImGui::Selectable(choices[i].c_str(), static_cast<int>(i) == chosen))
                chosen = static_cast<int>(i);
        ImGui::EndCombo();
    }
    note_widget(name);
    return chosen;
}

// "wear_by_water" as people write it.
std::string in_words(std::string name) {
    std::replace(name.begin(), name.end(), '_', ' ');
    return name;
}

// Of what is known by two names, one.
std::vector<std::string> listed_outputs() {
    std::vector<std::string> names = output_names();
    std::erase(names, "water");
    return names;
}

void choose_layer(io::ExportSettings& settings, bool& open) {
    const std::vector<std::string> names = listed_outputs();
    std::vector<std::string> words(names.size());
    std::transform(names.begin(), names.end(), words.begin(), in_words);
    const auto at = std::find(names.begin(), names.end(), settings.layer) - names.begin();
    settings.layer = names[static_cast<std::size_t>(choose("layer", words, static_cast<int>(at), open))];
}

void choose_maps(io::ExportSettings& settings, bool& open) {
    constexpr int columns = 3;
    if (ImGui::BeginTable("maps", columns)) {
        for (const std::string& map : listed_outputs()) {
            ImGui::TableNextColumn();
            const auto at = std::find(settings.maps.begin(), settings.maps.end(), map);
            bool chosen = at != settings.maps.end();
            if (ImGui::Checkbox(in_words(map).c_str(), &chosen)) {
                if (chosen)
                    settings.maps.push_back(map);
                else
                    settings.maps.erase(at);
            }
            note_widget("map " + map);
        }
        ImGui::EndTable();
    }
    const int weights = choose(
        "as", {"values", "weights of 8 bits, which sum to one", "weights of 16 bits, which sum to one"},
        settings.weight_bits / 8, open);
    settings.weight_bits = 8 * weights;
    constexpr std::array<io::ExportKind, 4> taken_by = {io::ExportKind::heightmap, io::ExportKind::unreal,
                                                        io::ExportKind::unity, io::ExportKind::godot};
    const auto at = std::find(taken_by.begin(), taken_by.end(), settings.samples_for) - taken_by.begin();
    const int taken =
        choose("samples",
               {"as the terrain has", "as Unreal takes them", "as Unity takes them", "as Godot takes them"},
               static_cast<int>(at), open);
    settings.samples_for = taken_by[static_cast<std::size_t>(taken)];
}

// Named after the scene, beside its file; another scene forgets what was named for the one before.
void propose_path(const Session& session, io::ExportSettings& settings) {
    if (!settings.path.empty()) return;
    const std::filesystem::path near = session.path().empty() ? session.request().input : session.path();
    std::error_code ignored;
    const auto folder = near.empty() ? std::filesystem::current_path(ignored) : near.parent_path();
    std::string name = near.empty() ? session.scene().title : near.stem().string();
    std::replace(name.begin(), name.end(), '/', '-');
    settings.path = folder / (name + "-export" + usual_ending(settings.kind));
}

}  // namespace

void draw_export_dialog(PanelContext& context) {
    ExportDialog& dialog = context.state.write;
    if (!dialog.shown) return;
    io::ExportSettings& settings = dialog.settings;
    propose_path(context.session, settings);
    if (!begin_dialog("Export", 36, 0, true)) return;
    const bool writes = context.work.busy();
    ImGui::BeginDisabled(writes);
    const float spacing = ImGui::GetStyle().ItemSpacing.x;
    const float third = (ImGui::GetContentRegionAvail().x - 2 * spacing) / 3;
    const std::vector<std::string>& kinds = io::export_kind_names();
    for (std::size_t i = 0; i < kinds.size(); ++i) {
        const auto kind = static_cast<io::ExportKind>(i);
        if (choice_button(kinds[i], settings.kind == kind, what_it_is(kind), third)) {
            settings.kind = kind;
            settings.path = io::with_other_ending(settings.path, usual_ending(kind));
            if (kind == io::ExportKind::maps && settings.maps.empty())
                settings.maps = {"ground", "flow", "wear", "deposition", "slope"};
        }
        if (i % 3 != 2 && i + 1 < kinds.size()) ImGui::SameLine();
    }
    ImGui::TextWrapped("%s", what_it_is(settings.kind).c_str());
    ImGui::Spacing();
    std::string path = settings.path.string();
    ImGui::SetNextItemWidth(-em(6));
    if (ImGui::InputText("##path", &path)) settings.path = path;
    note_widget("export path");
    ImGui::SameLine();
    if (button("Browse…", "the folder and the name of the file"))
        context.state.dialog.begin(FileDialog::Purpose::export_to, settings.path.string());
    bool choosing = false;
    if (settings.kind == io::ExportKind::maps)
        choose_maps(settings, choosing);
    else
        choose_layer(settings, choosing);
    if (settings.kind != io::ExportKind::maps) {
        label_before("Tiles east, south");
        ImGui::InputInt2("##tiles", &settings.tiles.x);
        settings.tiles = glm::clamp(settings.tiles, 1, 64);
    }
    if (settings.kind == io::ExportKind::mesh) {
        label_before("Largest error");
        ImGui::InputDouble("##error", &settings.mesh_error_m, 0, 0, "%.6g m");
    } else if (settings.kind != io::ExportKind::maps) {
        bool given = settings.range_m.has_value();
        label_before("Heights of integers");
        if (ImGui::Checkbox("##given", &given))
            settings.range_m = given ? std::optional<io::Range>(context.session.bounds()) : std::nullopt;
        tooltip_of("the heights of the smallest and of the largest integer; else those of the terrain");
        if (settings.range_m) {
            label_before("Smallest, largest");
            ImGui::InputScalarN("##range", ImGuiDataType_Double, &settings.range_m->x, 2, nullptr, nullptr,
                                "%.6g m");
        }
    }
    heading("What gets lost");
    follow_losses(context.session, dialog);
    ImGui::PushTextWrapPos(0);
    if (dialog.lost.empty()) ImGui::TextUnformatted("nothing");
    for (const std::string& lost : dialog.lost) {
        ImGui::Bullet();
        ImGui::TextUnformatted(lost.c_str());
    }
    ImGui::PopTextWrapPos();
    if (!dialog.error.empty()) {
        ImGui::PushStyleColor(ImGuiCol_Text, {1, 0.7F, 0.3F, 1});
        ImGui::TextWrapped("%s", dialog.error.c_str());
        ImGui::PopStyleColor();
    }
    ImGui::Spacing();
    // It stays until the files are there: what fails is said in it, and can be mended.
    if (button("Write", "",
               !writes && !settings.path.empty() &&
                   (settings.kind != io::ExportKind::maps || !settings.maps.empty()))) {
        settings.path = io::with_ending(settings.path, usual_ending(settings.kind));
        dialog.error.clear();
        context.requests.write = settings;
    }
    ImGui::EndDisabled();
    ImGui::SameLine();
    // While it is written, that is given up.
    if (button("Cancel export") || (!choosing && ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape)))) {
        if (writes)
            context.requests.cancel_work = true;
        else
            dialog.close();
    }
    if (!dialog.shown) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
}

}  // namespace talus::app
