#pragma once
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "app/core/session.h"
#include "sim/figure.h"

namespace talus::app {

struct PanelRequests;

/// Where a widget is in the window, pixels from the upper left. For tests, which find widgets by name.
struct WidgetRect {
    std::string name;
    float left = 0;
    float top = 0;
    float right = 0;
    float bottom = 0;
    bool operator==(const WidgetRect&) const = default;
};
/// The widgets of this frame so far; begin_widgets() forgets those of the one before.
const std::vector<WidgetRect>& widget_rects();
void begin_widgets();
/// Notes where the last ImGui item is.
void note_widget(const std::string& name);

/// A texture as ImGui takes it (ImTextureID).
void* panel_image(const gpu::Texture& texture);

/// Begins a dialog in the middle of the window, wherever that is now, as wide and high as given (in letters;
/// height 0: as its content) but never beyond the window. Where it is true, ImGui::EndPopup() ends it.
/// `grows`: its upper edge stays where it is while its content changes.
bool begin_dialog(const char* title, float width_em, float height_em = 0, bool grows = false);
/// Within a menu or a list of choices: Escape closes it.
void close_on_escape();
/// A button that is named and explained.
bool button(const std::string& name, const std::string& tooltip = "", bool enabled = true);
/// A button that stays down while chosen, as wide as given (0: as its text).
bool choice_button(const std::string& name, bool chosen, const std::string& tooltip, float width);
/// What a button with an icon looks like.
struct IconButton {
    std::string icon;     ///< app/core/icon.h
    float width = 0;      ///< pixels; 0: as its text
    bool chosen = false;  ///< it stays down
    bool enabled = true;
    std::string id = "";  ///< of one whose name changes: keys stay on it; empty: its name
};
bool icon_button(const std::string& name, const std::string& tooltip, const IconButton& looks);
/// A line of a menu. `label`: what is read there, if that is not its name.
bool menu_item(const std::string& name, const char* keys, bool enabled = true, bool chosen = false,
               const std::string& label = "");
/// A line that is chosen by a click, its text as it is: ImGui takes what stands behind "##" for no text.
/// `flags`: ImGui's of a selectable.
bool selectable_text(const std::string& text, bool chosen = false, int flags = 0);
/// A text as it is where it fits, else the longest beginning that fits with an ellipsis behind it; whole
/// letters, UTF-8.
std::string shortened(const std::string& text, const std::function<bool(const std::string&)>& fits);
/// Begins a tooltip of the last item: beside the panel where that is at one of the window's sides, so that it
/// covers none of its widgets.
void begin_tooltip();
/// Explains the last item, where the mouse is over it; nothing where the text is empty.
void tooltip_of(const std::string& text);
/// A label on the left, and room for the next item on its right.
void label_before(const std::string& label);
/// A line of text that ends with an ellipsis where the panel does; whole in the tooltip then.
void text_line(const std::string& text);
/// A name on the left and what it is on the right.
void figure_line(const std::string& name, const std::string& value);
/// A text in one of the theme's colours, over several lines where it does not fit into one.
void coloured_text(glm::vec4 colour, const std::string& text);
/// A heading within a panel.
void heading(const char* text);

/// What a person did to a parameter: nothing, gave it a value, or took back that one was ever given.
enum class Edit { none, set, unset };
/// A declared parameter: name, value with unit, a tooltip with help and range. A right click unsets it, Ctrl
/// and a click take an exact number. The value is changed where it was set.
Edit draw_parameter(const Parameter& parameter, Value& value);
/// One of the session's parameters, set as it changes. `declared`: as it is, but that its unit may be
/// another.
void draw_declared(const Session& session, PanelRequests& requests, const Parameter& declared);
/// The session's parameters of these names, set as they change.
void draw_parameters(const Session& session, PanelRequests& requests, const std::vector<std::string>& names);
/// The session's parameters of a section.
std::vector<std::string> names_in(const Session& session, const std::string& section);
/// All parameters of a section, set as they change.
void draw_section(const Session& session, PanelRequests& requests, const std::string& section);

/// A parameter's label with its section, where those of several are listed together: "water: Rain".
std::string shown_name(const Parameter& p);
/// A parameter's unit as part of a format: its percent signs doubled.
std::string unit_in_format(const Parameter& p);

/// How a number is shown, and between what it may lie.
struct NumberField {
    const char* format;
    double low;
    double high;
    double step = 0;  ///< that a pixel of a drag changes it by, at least; 0: by its range
};
/// A number that is set once it is let go, so that a drag is one act: true then. Until then it is kept in
/// `in_hand`, by its name.
bool number_until_let_go(std::map<std::string, double>& in_hand, const std::string& name,
                         const NumberField& field, double& value);

/// A line of values with its name, its last value and its range.
void plot_line(const char* label, const std::vector<float>& values, const char* unit);

}  // namespace talus::app
