#pragma once
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "app/panels/widgets.h"
#include "app/recovery.h"
#include "app/self_check.h"
#include "app/session.h"
#include "app/work.h"
#include "sim/gpu/profile.h"
#include "sim/io/export.h"

namespace talus {

/// A file, and how it is read.
struct ImportWish {
    std::string path;
    ImportSettings settings = ImportSettings();
};

/// What panels ask the window to do, once the frame's panels are done.
struct PanelRequests {
    std::optional<SceneRequest> open;       ///< another scene; unsaved work is asked about
    std::optional<std::string> save;        ///< the document, to this path
    std::optional<std::string> import;      ///< a file, by the import dialog
    std::optional<ImportWish> look_at;      ///< a file, shown by the same dialog, whatever kind it is of
    std::optional<ImportWish> import_here;  ///< a file in place of the terrain
    std::optional<std::string> stamp;       ///< a file, as the stamp
    std::optional<ExportSettings> write;    ///< files for other programs
    std::optional<Operation> map;           ///< an act on the whole map, which may take long
    bool reset = false;
    bool verify = false;  ///< what Talus claims of its numbers, on this device
    bool undo = false;
    bool redo = false;
    bool quit = false;
    bool framing = false;
    bool picture = false;                             ///< saved as a file
    std::vector<std::function<void(Session&)>> acts;  ///< may throw; done after the panels
    std::function<void()> answer;                     ///< to a question; may throw
    bool cancel_work = false;                         ///< the long work that goes on
    /// Whether anything was asked that may change title or picture.
    bool any() const;
};

/// What the status line says besides the session's own figures.
struct StatusFigures {
    std::string device;
    std::string message;
    std::optional<double> cursor_height_m;
    double frame_ms = 0;
    double scale = 1;
};

/// A dialog that picks a path; the window keeps one.
struct FileDialog {
    enum class Purpose { none, open, save, import, stamp };
    Purpose purpose = Purpose::none;
    std::string folder;
    std::string name;
    std::string error;
    bool accepted = false;   ///< Enter was pressed
    bool cancelled = false;  ///< Escape was pressed
    void begin(Purpose what, const std::string& near);
};

/// What a file holds when it is read so.
struct ImportPreview {
    ImportWish wish;
    std::string error;  ///< what is wrong with it; else:
    Grid grid;
    float low_m = 0;
    float high_m = 0;
    std::vector<std::string> notes;
    std::string kind;
    std::string crs;
    std::vector<std::uint8_t> picture;  ///< RGBA, of its ground
    glm::ivec2 picture_size{0};
};
/// Reads it. Takes long where the file is large; touches no OpenGL.
ImportPreview preview_of(const ImportWish& wish);

/// A heightmap that is to be opened or imported: how it is read, and what it looks like then.
struct ImportDialog {
    std::string path;  ///< empty: the dialog is not there
    ImportSettings settings;
    double spacing_m = 1;
    double low_m = 0;
    double high_m = 1000;
    glm::ivec2 raw_size{0};
    bool big_endian = false;
    bool south_first = false;
    std::vector<std::string> notes;
    std::string kind;
    std::string crs;
    std::string error;
    glm::ivec2 samples{0};
    gpu::Texture preview;
    glm::ivec2 preview_size{0};
    /// What a person chose, until it can be done.
    enum class Then { stay, open, import_here } then = Then::stay;
    /// Shows what was found.
    void show(const ImportPreview& found);
};

/// Files for other programs: what is written and what gets lost.
struct ExportDialog {
    bool shown = false;
    ExportSettings settings;
    std::string error;
    std::optional<TerrainState> state;  ///< read when the dialog opens
    std::vector<std::string> lost;      ///< with the settings as text below
    std::string lost_with;
    void close();
};

/// A question with two or three answers, in the middle of the window.
struct Question {
    std::string text;
    std::vector<std::pair<std::string, std::function<void()>>> answers;  ///< the last one: Escape
};

/// What the panels keep between frames.
struct PanelState {
    std::string shown = "Simulation";  ///< of the panels on the right
    bool panels_shown = true;
    bool start_page = false;
    bool placing_gauge = false;
    FileDialog dialog;
    ImportDialog import;
    ExportDialog write;
    std::optional<Question> question;
    std::optional<SelfCheck> self_check;  ///< what was found of this device, while it is shown
    std::vector<std::string> recent;      ///< files, the last one first
    std::vector<LeftBehind> left;         ///< by sessions that ended without saving
    std::vector<std::string> log;         ///< what was said, oldest first
    std::vector<gpu::PassTime> passes;    ///< of the last half second
    double passes_s = 0;                  ///< how long that was
    std::map<std::string, gpu::Texture> thumbnails;
};

/// Whether a dialog stands over everything else and has the keys.
bool is_dialog_open(const PanelState& state);

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
/// Acts on the whole map: its size and place, its heights, noise, another heightmap.
void draw_map_panel(PanelContext& context);
/// What was done, by name; a click goes there.
void draw_history_panel(PanelContext& context);
/// The ledger of rock and water, followed while it is open: its last reading, its stores and what is missing
/// against time, and a button to read it now.
void draw_ledger_panel(PanelContext& context);
/// Gauges: a button to place one by the next click, and for each its level and speed against time.
void draw_gauges_panel(PanelContext& context);
void draw_profiler_panel(PanelContext& context);
void draw_presets_panel(PanelContext& context);
void draw_log_panel(PanelContext& context);

/// Presets with their pictures, in as many columns as there is room for; a click opens one.
void draw_preset_grid(PanelContext& context);
void draw_start_page(PanelContext& context, glm::ivec2 size);
void draw_file_dialog(PanelContext& context);
void draw_import_dialog(PanelContext& context);
void draw_export_dialog(PanelContext& context);
void draw_question(PanelContext& context);
/// What `talus verify` found.
void draw_self_check_dialog(PanelContext& context);
/// A bar for long work, with a button to give it up.
void draw_work(const Work& work, bool& cancelled);
void draw_status_line(const Session& session, const StatusFigures& figures, int width, int height);
/// A sentence over the picture.
void draw_notice(const std::string& message, const PictureArea& area);
/// Where gauges stand in the picture, and the line of a ramp that is being drawn.
void draw_marks(const Session& session, const PictureArea& area);

}  // namespace talus
