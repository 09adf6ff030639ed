#include "app/window/glfw.h"

#include <GLFW/glfw3.h>
#include <fmt/format.h>

#include "sim/error.h"
#include "sim/gpu/context.h"

namespace talus::app {
namespace {

std::string glfw_error() {
    const char* text = nullptr;
    glfwGetError(&text);
    return text ? text : "no reason given";
}

}  // namespace

Glfw::Glfw() {
    gpu::work_around_drivers();
    if (!glfwInit()) throw Error(fmt::format("no window can open: {}", glfw_error()));
}

Glfw::~Glfw() {
    glfwTerminate();
}

GLFWwindow* Glfw::open(glm::ivec2 size, bool visible) const {
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 5);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_DEBUG_CONTEXT, GLFW_TRUE);
    glfwWindowHint(GLFW_VISIBLE, visible ? GLFW_TRUE : GLFW_FALSE);
    GLFWwindow* window = glfwCreateWindow(size.x, size.y, "Talus", nullptr, nullptr);
    if (!window) throw Error(fmt::format("no window with OpenGL 4.5 can open: {}", glfw_error()));
    glfwMakeContextCurrent(window);
    return window;
}

std::string why_no_window() {
    try {
        const Glfw glfw;
        glfw.open({64, 64}, false);
        gpu::adopt_current_context("window");
        return "";
    } catch (const Error& error) {
        return error.what();
    }
}

}  // namespace talus::app
