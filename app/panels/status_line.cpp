#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "app/core/place_text.h"
#include "app/panels/panels.h"
#include "app/panels/style.h"

namespace talus::app {
namespace {

// A height without -0.0.
std::string height_text(double height_m) {
    return fmt::format("{:.1f}", std::round(height_m * 10) / 10 + 0.0);
}

// Where the mouse is on the ground, in the file's coordinates where there are any.
std::string cursor_text(const Session& session, const std::optional<glm::dvec3>& cursor) {
    if (!cursor) return "–";
    const std::string on_earth = file_coordinates_text(session, *cursor);
    const std::string place =
        on_earth.empty() ? fmt::format("x, y {:.1f}, {:.1f}", cursor->x, cursor->y) : on_earth;
    return fmt::format("{}: {} m", place, height_text(cursor->z));
}

std::string status_text(const Session& session, const StatusFigures& figures) {
    const Grid& grid = session.grid();
    const glm::dvec2 heights_m = session.heights_m();
    std::string text = fmt::format("{} × {} samples, {} × {} m  |  {} to {} m  |  {}  |  ", grid.nx, grid.ny,
                                   figure(grid.dx, 4), figure(grid.dy, 4), height_text(heights_m.x),
                                   height_text(heights_m.y), cursor_text(session, figures.cursor));
    if (const Overflight* overflight = session.overflight())
        text += fmt::format("{}  |  ", overflight->tiles().state());
    else
        text += fmt::format("{:.2f} s, speed {} of {}  |  tick {:.1f} ms, ",
                            session.simulation().clock().simulated_s, figure(session.speed_reached(), 3),
                            figure(session.view().number("time.speed"), 3), session.tick_ms());
    if (const Surroundings* around = session.surroundings()) {
        if (!around->tiles().terrain().is_measured) text += "a sketch around it, ";
        if (around->tiles().awaited_tiles() > 0)
            text += fmt::format("{} tiles on their way, ", around->tiles().awaited_tiles());
    }
    const std::string photo = session.photo() ? session.photo()->state() : "";
    if (!photo.empty()) text += photo + ", ";
    return text + fmt::format("frame {:.1f} ms at {:.0f} %  |  {}", figures.frame_ms, 100 * figures.scale,
                              figures.device);
}

}  // namespace

float status_height() {
    return em(1) + 8;
}

// At the upper edge of the picture: at the lower one are its legends.
void draw_notice(const std::string& message, const PictureArea& area) {
    if (message.empty()) return;
    // What does not fit into a line goes on in the next.
    const float room = std::clamp(static_cast<float>(area.size.x) - em(2), em(12), em(60));
    const ImVec2 text_size = ImGui::CalcTextSize(message.c_str(), nullptr, false, room);
    const float middle = static_cast<float>(area.corner.x) + static_cast<float>(area.size.x) / 2;
    const float left = std::max(middle - text_size.x / 2, 10.0F);
    const float top = static_cast<float>(area.corner.y) + em(0.8F);
    ImDrawList* list = ImGui::GetForegroundDrawList();
    list->AddRectFilled({left - 10, top - 5}, {left + text_size.x + 10, top + text_size.y + 5},
                        colour_of(theme().notice), 4);
    list->AddText(nullptr, 0, {left, top}, colour_of(theme().text), message.c_str(), nullptr, room);
}

void draw_status_line(const Session& session, const StatusFigures& figures, int width, int height) {
    ImDrawList* list = ImGui::GetForegroundDrawList();
    const float line = status_height();
    const auto w = static_cast<float>(width);
    const auto h = static_cast<float>(height);
    const std::string text = shortened(status_text(session, figures), [&](const std::string& some) {
        return ImGui::CalcTextSize(some.c_str()).x <= w - 16;
    });
    list->AddRectFilled({0, h - line}, {w, h}, colour_of(theme().bar));
    list->AddText({8, h - line + 4}, colour_of(theme().text), text.c_str());
}

}  // namespace talus::app
