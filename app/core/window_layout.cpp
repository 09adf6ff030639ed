#include "app/core/window_layout.h"

#include <fmt/format.h>

#include <toml++/toml.h>
#include <algorithm>
#include <cmath>
#include <filesystem>

#include "app/core/user_folders.h"
#include "sim/io/atomic_file.h"

namespace talus::app {
namespace {

std::string side_text(const char* name, const PanelSide& side) {
    return fmt::format("{0}_em = {1:.2f}\n{0}_folded = {2}\n", name, side.width_em, side.folded);
}

}  // namespace

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
        const auto read_side = [&](const std::string& name, PanelSide& to) {
            const float width_em = table[name + "_em"].value_or(to.width_em);
            if (std::isfinite(width_em)) to.width_em = std::clamp(width_em, 10.0F, 60.0F);
            to.folded = table[name + "_folded"].value_or(to.folded);
        };
        read_side("tools", layout.tools_side);
        read_side("panels", layout.panels_side);
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
                        layout.size.x, layout.size.y, layout.panel, layout.panels_shown, layout.theme) +
                side_text("tools", layout.tools_side) + side_text("panels", layout.panels_side));
    } catch (const std::exception&) {
        // It is a convenience.
    }
}

}  // namespace talus::app
