#pragma once
#include <optional>
#include <string>

#include "app/core/scene.h"

namespace talus::app {

struct WindowOptions {
    SceneRequest scene;
    std::string journal;             ///< written on every save and at the end
    std::optional<glm::ivec2> size;  ///< unless given, as it was when it was last closed
    double ui_scale = 0;             ///< of panels and text; 0: as the display asks for
    std::string theme;               ///< of panels; empty: as it was when it was last closed
    std::string frame_log;           ///< a table of what every frame took, written at the end; empty: none
    std::string ui_rects;  ///< a file that says where every named widget is, kept up to date; empty: none
};

/// Opens the window and returns when it is closed. Throws talus::Error when it cannot open.
void run_window(const WindowOptions& options);

}  // namespace talus::app
