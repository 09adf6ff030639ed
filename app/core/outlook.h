#pragma once
#include <optional>
#include <string>

#include "render/camera.h"
#include "sim/parameters.h"
#include "sim/terrain/grid.h"
#include "sim/terrain/reshape.h"

namespace talus::app {
class Session;

/// What somebody sees of a terrain in tiles, or around a part of it.
struct Outlook {
    std::string whole;          ///< the file
    Grid grid;                  ///< its
    render::Camera over_whole;  ///< among its metres
    Parameters view;
    Rectangle part;  ///< that is chosen or worked in, in its metres
};

/// None where the session shows nothing in tiles.
std::optional<Outlook> outlook_of(const Session& session);

/// Whether the session looks at a mosaic that the terrain before is a part of, as large as that.
bool is_over(const Session& session, const Outlook& before);

/// Sun, view and way of flying stay, and the camera is where it was over the whole. What hangs on the
/// terrain's own rectangle does not. The session must show something in tiles.
void look_as(Session& session, const Outlook& before);

}  // namespace talus::app
