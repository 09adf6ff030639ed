#include "sim/gpu/debug.h"

#include <epoxy/gl.h>

#include <string>

#include "sim/error.h"

namespace talus::gpu {
namespace {

thread_local std::string first_error;

void GLAPIENTRY keep_message(GLenum /*source*/, GLenum type, GLuint /*id*/, GLenum severity, GLsizei length,
                             const GLchar* message, const void* /*user*/) {
    if (type != GL_DEBUG_TYPE_ERROR && severity != GL_DEBUG_SEVERITY_HIGH) return;
    if (first_error.empty())
        first_error.assign(message, length < 0 ? std::char_traits<char>::length(message) : length);
}

}  // namespace

void watch_errors() {
    first_error.clear();
    glEnable(GL_DEBUG_OUTPUT);
    glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
    glDebugMessageCallback(keep_message, nullptr);
    glDebugMessageControl(GL_DONT_CARE, GL_DONT_CARE, GL_DEBUG_SEVERITY_NOTIFICATION, 0, nullptr, GL_FALSE);
}

void raise_errors() {
    if (first_error.empty()) return;
    std::string message;
    message.swap(first_error);
    throw Error("OpenGL reports: " + message);
}

void forget_errors() {
    first_error.clear();
}

}  // namespace talus::gpu
