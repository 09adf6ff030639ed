#pragma once
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/session.h"

namespace talus {

/// What panels ask the window to do, once the frame's panels are done.
struct PanelRequests {
    std::optional<std::string> open;
    std::optional<std::string> save;
    bool reset = false;
    bool undo = false;
    bool redo = false;
    bool quit = false;
    bool framing = false;
    bool picture = false;                             ///< saved as a file
    std::vector<std::function<void(Session&)>> acts;  ///< may throw; done after the panels
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
    enum class Purpose { none, open, save };
    Purpose purpose = Purpose::none;
    std::string folder;
    std::string name;
    std::string error;
    bool accepted = false;   ///< Enter was pressed
    bool cancelled = false;  ///< Escape was pressed
    void begin(Purpose what, const std::string& near);
};

/// Menu bar and main panel: play, undo, tools and every declared parameter.
void draw_main_panel(Session& session, FileDialog& dialog, bool& placing_gauge, PanelRequests& requests);
void draw_status_line(const Session& session, const StatusFigures& figures, int width, int height);
void draw_file_dialog(FileDialog& dialog, PanelRequests& requests);
/// How a file was read, kept by the window: what its reader guessed, and fields to read it again otherwise.
struct ImportPanel {
    bool shown = true;
    double spacing_m = 1;
    double low_m = 0;
    double high_m = 1000;
    std::string raw;  ///< as --raw takes it
    void follow(const Session& session);
};
void draw_import_panel(const Session& session, ImportPanel& panel, PanelRequests& requests);

/// Gauges: a button to place one by the next click, and for each its level and speed against time; marks
/// where they stand in the picture.
void draw_gauges_panel(Session& session, bool& placing, PanelRequests& requests);
void draw_gauge_marks(const Session& session, int width, int height);

/// The ledger of rock and water, followed while it is open: its last reading, its stores and what is missing
/// against time, and a button to read it now.
void draw_ledger_panel(Session& session, PanelRequests& requests);

/// A line of values with its name, its last value and its range.
void plot_line(const char* label, const std::vector<float>& values, const char* unit);

/// A widget for a declared parameter: name, unit, tooltip with help and range; right click resets to the
/// default. True when the value changed.
bool draw_parameter(const Parameter& parameter, Value& value);

}  // namespace talus
