#pragma once
#include <glm/glm.hpp>
#include <string>

struct GLFWwindow;

namespace talus::app {

/// GLFW's life: from its start to its end. Throws talus::Error where no window can open.
class Glfw {
  public:
    Glfw();
    ~Glfw();
    Glfw(const Glfw&) = delete;
    Glfw& operator=(const Glfw&) = delete;

    /// A window with OpenGL 4.5, which is current then. Throws talus::Error where none can open.
    GLFWwindow* open(glm::ivec2 size, bool visible) const;
};

/// Why no window can open here: no display, a dead one, OpenGL below 4.5. Empty: one can.
std::string why_no_window();

}  // namespace talus::app
