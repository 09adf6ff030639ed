#include "app/core/window_layout.h"

#include <fmt/format.h>

#include <toml++/toml.h>
#include <algorithm>
#include <filesystem>

#include "app/core/user_folders.h"
#include "sim/io/atomic_file.h"

namespace talus::app {

WindowLayout read_window_layout() {
    WindowLayout layout;
    try {
        const toml::table table = toml::parse_file((config_folder() / "window.toml").string());
        const auto side = [&](const char* name, int otherwise) {
            return static_cast<int>(
                std::clamp<std::int64_t>(table[name].value_or<std::int64_t>(otherwise), 320, 16384));
        };
        layout.size = {side("width", layout.size.x), side("height", layout.size.y)};
        layout.panel = table["panel"].value_or(layout.panel);
        layout.panels_shown = table["panels_shown"].value_or(true);
        layout.theme = table["theme"].value_or(layout.theme);
    } catch (const toml::parse_error&) {
        // Not there yet, or not ours.
    }
    return layout;
}

void keep_window_layout(const WindowLayout& layout) {
    try {
        std::filesystem::create_directories(config_folder());
        io::write_atomically(
            config_folder() / "window.toml",
            fmt::format("width = {}\nheight = {}\npanel = \"{}\"\npanels_shown = {}\ntheme = \"{}\"\n",
                        layout.size.x, layout.size.y, layout.panel, layout.panels_shown, layout.theme));
    } catch (const std::exception&) {
        // It is a convenience.
    }
}

}  // namespace talus::app
