#pragma once
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/core/desktop_dialog.h"
#include "app/core/folder_listing.h"
#include "app/core/map_mark.h"
#include "app/core/new_terrain.h"
#include "app/core/recovery.h"
#include "app/core/self_check.h"
#include "app/core/session.h"
#include "app/core/stamp_folder.h"
#include "app/core/window_layout.h"
#include "sim/gpu/profile.h"
#include "sim/io/export.h"

namespace talus::app {

/// A file, and how it is read.
struct ImportWish {
    std::string path;
    io::ImportSettings settings = io::ImportSettings();
};

/// What panels ask the window to do, once the frame's panels are done.
struct PanelRequests {
    std::optional<SceneRequest> open;         ///< another scene; unsaved work is asked about
    std::optional<std::string> save;          ///< the document, to this path
    std::optional<std::string> save_scene;    ///< generator and settings, to this path
    std::optional<std::string> put_back;      ///< the ground into the whole, as this mosaic
    std::optional<std::string> import;        ///< a file, by the import dialog where it needs one
    std::optional<std::string> import_shown;  ///< a file, by the import dialog whatever kind it is of
    std::optional<ImportWish> look_at;        ///< a file, shown by the same dialog, whatever kind it is of
    std::optional<ImportWish> import_here;    ///< a file in place of the terrain
    std::optional<std::string> stamp;         ///< a file, as the stamp
    std::optional<std::string> table;         ///< a file, as the table of the number that is chosen
    std::optional<std::string> raster;        ///< a file, as the raster of the painted number that is chosen
    std::optional<io::ExportSettings> write;  ///< files for other programs
    std::optional<std::string> export_to;     ///< a file that the dialog of exports is to write
    std::optional<Operation> map;             ///< an act on the whole map, which may take long
    bool reset = false;
    bool verify = false;  ///< what Talus claims of its numbers, on this device
    bool undo = false;
    bool redo = false;
    bool quit = false;
    bool framing = false;
    bool picture = false;                             ///< saved as a file
    bool record = false;                              ///< a film begins, or ends
    std::vector<std::function<void(Session&)>> acts;  ///< may throw; done after the panels
    /// A value that a parameter is to have.
    struct Awaited {
        std::optional<Value> value;  ///< none: unset
        std::size_t after_acts = 0;  ///< behind so many of the acts above
    };
    std::map<std::string, Awaited> parameters;  ///< by name; panels show them already
    std::function<void()> answer;               ///< to a question; may throw
    bool answer_at_once = false;                ///< it needs no whole tick
    bool cancel_work = false;                   ///< the long work that goes on
    /// Whether anything was asked that may change title or picture.
    bool any() const;
};

/// A dialog that picks a path; the window keeps one.
struct FileDialog {
    enum class Purpose { none, open, save, save_scene, import, stamp, table, raster, put_back, export_to };
    Purpose purpose = Purpose::none;
    std::string folder;
    std::string name;
    std::string error;
    bool accepted = false;             ///< Enter was pressed
    bool cancelled = false;            ///< Escape was pressed
    std::vector<FolderEntry> entries;  ///< of the folder, as sorted
    double listed_at_s = 0;            ///< when they were read, by the clock on the wall
    ListedBy by = ListedBy::name;
    bool descending = false;
    bool all_files = false;                            ///< those too that the purpose has no use for
    std::unique_ptr<DesktopDialog> desktop = nullptr;  ///< that is open in its place
    void go_to(const std::string& another_folder);
    /// Lists the folder anew where that was a while ago. Once a frame.
    void follow_folder();
    void sort() { sort_entries(entries, by, descending); }
    void begin(Purpose what, const std::string& near);
    /// To put the session's scene back, which must have been cut out.
    void begin_put_back(const Session& session);
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
    io::ImportSettings settings;
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
    io::ExportSettings settings;
    std::string error;
    std::optional<TerrainState> state;  ///< read when the dialog opens
    std::vector<std::string> lost;      ///< with the settings as text below
    std::string lost_with;
    void close();
};

/// A question with two or three answers, in the middle of the window.
struct Question {
    std::string text;
    struct Answer {
        std::string words;
        std::function<void()> act;
        bool at_once = false;  ///< it needs no whole tick: nothing of the terrain is kept
    };
    std::vector<Answer> answers;  ///< the last one: Escape
};

/// A table's plot, and the table that it is of.
struct TablePlot {
    TimeSeries of;
    std::vector<float> values;
};

/// A control of erosion that is being moved: it is set when it is let go.
struct ControlInHand {
    std::string name;
    float position = 0;
};

/// What a key or the mouse does: a line of the list that F1 shows.
struct KeyLine {
    std::string keys;  ///< "Ctrl+Z"; empty: `what` is a heading
    std::string what;
};

/// Where keys without Ctrl move something: in the picture, or from widget to widget.
enum class KeyboardIn { picture, tools, panels };

/// What the panels keep between frames.
struct PanelState {
    std::string shown = "Simulation";  ///< of the panels on the right
    bool panels_shown = true;
    PanelSide tools_side = WindowLayout().tools_side;  ///< the tools at the left
    PanelSide panels_side = WindowLayout().panels_side;
    bool start_page = false;
    std::optional<MarkKind> placing;                ///< by the next click on the ground
    std::map<std::string, double> numbers_in_hand;  ///< that are set when they are let go
    std::optional<MapDrag> drawing;                 ///< by the next drag over the ground
    bool drawing_path = false;
    std::string mode_before_top = "orbit";  ///< of the camera, before it looked straight down
    std::optional<ControlInHand> control_in_hand;
    /// Somebody takes a tool of the brush: the next click on the ground is the brush's.
    void take_brush() {
        placing.reset();
        drawing.reset();
        drawing_path = false;
    }
    std::string table_of = "water.rain_mm_per_h";  ///< the number that is to follow a table
    bool table_begins_now = true;
    std::string event_sets = "water.rain_mm_per_h";  ///< what the next event sets
    std::string raster_of = "manning";               ///< the painted number that a raster is to bring
    std::map<std::string, TablePlot> table_plots;    ///< by the number that follows
    bool choosing_part = false;  ///< the next drag over tiles chooses the part that is cut out
    bool only_looks = false;     ///< the terrain is in tiles: what changes it is not there
    FileDialog dialog;
    ImportDialog import;
    ExportDialog write;
    NewTerrain fresh;           ///< the dialog that generates one
    std::string recording;      ///< how long the film is, and what it costs; empty: none is recorded
    std::vector<KeyLine> keys;  ///< what all of them do
    KeyboardIn keyboard_in = KeyboardIn::picture;
    KeyboardIn keyboard_was_in = KeyboardIn::picture;  ///< in the frame before
    bool keys_shown = false;                           ///< in a dialog
    std::string camera_name;                           ///< of the camera that is to be kept
    std::optional<Question> question;
    std::optional<SelfCheck> self_check;  ///< what was found of this device, while it is shown
    std::vector<std::string> recent;      ///< files, the last one first
    std::vector<LeftBehind> left;         ///< by sessions that ended without saving
    std::vector<std::string> log;         ///< what was said, oldest first
    std::vector<gpu::PassTime> passes;    ///< of the last half second
    double passes_s = 0;                  ///< how long that was
    std::map<std::string, gpu::Texture> thumbnails;
    StampFolder own_stamps;
};

/// Whether a dialog stands over everything else and has the keys.
bool is_dialog_open(const PanelState& state);

}  // namespace talus::app
