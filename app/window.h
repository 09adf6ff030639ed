#pragma once
#include "app/commands/commands.h"

namespace talus {

struct WindowOptions {
    SceneRequest scene;
    std::string journal;  ///< written on every save and at the end
    glm::ivec2 size{1280, 720};
};

/// Why no window can open here: no display, a dead one, OpenGL below 4.5. Empty: one can.
std::string why_no_window();

/// Opens the window and returns when it is closed. Throws talus::Error when it cannot open.
void run_window(const WindowOptions& options);

}  // namespace talus
