#pragma once
#include <optional>
#include <string>
#include <vector>

#include "app/core/dialogs.h"
#include "app/core/session.h"
#include "app/core/work.h"
#include "app/panels/widgets.h"

namespace talus::app {

/// What the status line says besides the session's own figures.
struct StatusFigures {
    std::string device;
    std::string message;
    std::optional<glm::dvec3> cursor;  ///< where the mouse is on the ground
    double frame_ms = 0;
    double scale = 1;
};

/// What a panel is drawn from, and where it says what a person wants.
struct PanelContext {
    Session& session;
    PanelState& state;
    PanelRequests& requests;
    const Work& work;
};

/// Menu bar, tools on the left, a panel on the right, status line; dialogs over them.
void draw_panels(PanelContext& context, const StatusFigures& figures, glm::ivec2 size);
/// The part of a window of this size that panels leave to the picture, pixels: its corner from the upper
/// left, its size.
struct PictureArea {
    glm::ivec2 corner{0};
    glm::ivec2 size{1};
};
PictureArea picture_area(const PanelState& state, glm::ivec2 size);
/// Names of the panels on the right.
std::vector<std::string> panel_names();

void draw_menu(PanelContext& context);
void draw_tools_panel(PanelContext& context);
void draw_simulation_panel(PanelContext& context);
void draw_water_panel(PanelContext& context);
void draw_erosion_panel(PanelContext& context);
void draw_view_panel(PanelContext& context);
void draw_mask_panel(PanelContext& context);
/// Roads, rivers, walls and ditches: their points, how they will be, and the act that builds them.
void draw_paths_panel(PanelContext& context);
/// Springs: a button to place one by the next click, and for each its rate and its place.
void draw_springs(PanelContext& context);
/// A button after which the next click on the ground places one of the kind.
void place_button(PanelState& state, MarkKind kind, const char* words);
/// A button after which the next drag over the ground draws that.
void draw_button(PanelState& state, MapDrag what, const char* words, const char* tooltip);
/// Where something stands, m, as numbers that can be changed; in the file's coordinates too, where there are
/// any. The place that was given, once it is.
std::optional<glm::dvec2> place_fields(PanelContext& context, const std::string& name, glm::dvec2 place_m);
/// Acts on the whole map: its size and place, its heights, noise, another heightmap.
void draw_map_panel(PanelContext& context);
/// The part of a terrain in tiles that is cut out to be worked in, and the way back.
void draw_cut_out_panel(PanelContext& context);
/// Whether what stands around the terrain can be shown and hidden.
bool has_backdrop_switch(const Session& session);
/// Whether there is one: the terrain is in tiles, or was cut out.
bool has_cut_out_panel(const Session& session);
/// What was done, by name; a click goes there.
void draw_history_panel(PanelContext& context);
/// The ledger of rock and water, followed while it is open: its last reading, its stores and what is missing
/// against time, and a button to read it now.
void draw_ledger_panel(PanelContext& context);
/// Gauges and sections: buttons to place one by the next click or drag, and for each what it shows against
/// time.
void draw_gauges_panel(PanelContext& context);
/// What happens by itself at a time: what is set, which dam breaks, when; all of it can be changed.
void draw_events(PanelContext& context);
/// Tables against time: which number follows one, from which file, and where in it time is. Rasters of
/// painted numbers, and events.
void draw_tables_panel(PanelContext& context);
void draw_profiler_panel(PanelContext& context);
void draw_presets_panel(PanelContext& context);
void draw_log_panel(PanelContext& context);

/// Presets with their pictures, in as many columns as there is room for; a click opens one.
void draw_preset_grid(PanelContext& context);
void draw_start_page(PanelContext& context, glm::ivec2 size);
void draw_file_dialog(PanelContext& context);
void draw_import_dialog(PanelContext& context);
/// A terrain that is to be generated, with a small picture of it.
void draw_new_dialog(PanelContext& context);
void draw_export_dialog(PanelContext& context);
/// Whether the camera looks straight down, as on a map (camera.mode).
bool is_from_top(const Session& session);
/// Makes it do so, or goes back to what it did before.
void toggle_top_view(Session& session, PanelState& state);
/// On the picture of an orthographic view: a line of round length with what it measures on the ground.
void draw_scale_bar(const render::Camera& camera, const PictureArea& area);
/// What keys and mouse do.
void draw_keys_dialog(PanelContext& context);
void draw_question(PanelContext& context);
/// What `talus verify` found.
void draw_self_check_dialog(PanelContext& context);
/// A bar for long work, with a button to give it up.
void draw_work(const Work& work, bool& cancelled);
/// At the lower edge of the picture a bar for tiles that are made ready, with the time left and a button to
/// stop it.
void draw_preparation(const Work& work, const PictureArea& area, bool& stopped);
/// Of the status line, pixels.
float status_height();
void draw_status_line(const Session& session, const StatusFigures& figures, int width, int height);
/// A sentence over the picture.
void draw_notice(const std::string& message, const PictureArea& area);

}  // namespace talus::app
