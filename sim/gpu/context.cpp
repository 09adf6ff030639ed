#include "sim/gpu/context.h"

#include <epoxy/egl.h>
#include <epoxy/gl.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <string_view>
#include <utility>

#include "sim/error.h"
#include "sim/gpu/debug.h"
#include "sim/gpu/hazards.h"

namespace talus::gpu {
namespace {

struct Candidate {
    EGLDisplay display = EGL_NO_DISPLAY;
    std::string route;
    bool software = false;
};

bool has_word(const char* words, std::string_view word) {
    return words && std::string_view(words).find(word) != std::string_view::npos;
}

// Hardware devices first, software devices after them, the surfaceless platform last.
std::vector<Candidate> list_candidates() {
    std::vector<Candidate> candidates;
    const char* client = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
    if (has_word(client, "EGL_EXT_device_base") ||
        (has_word(client, "EGL_EXT_device_enumeration") && has_word(client, "EGL_EXT_device_query"))) {
        std::array<EGLDeviceEXT, 64> devices{};
        EGLint count = 0;
        if (eglQueryDevicesEXT(static_cast<EGLint>(devices.size()), devices.data(), &count)) {
            for (int i = 0; i < count; ++i) {
                const bool software =
                    has_word(eglQueryDeviceStringEXT(devices[i], EGL_EXTENSIONS), "EGL_MESA_device_software");
                candidates.push_back({eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT, devices[i], nullptr),
                                      fmt::format("EGL device {}", i), software});
            }
        }
    }
    std::stable_sort(candidates.begin(), candidates.end(),
                     [](const Candidate& a, const Candidate& b) { return a.software < b.software; });
    if (has_word(client, "EGL_MESA_platform_surfaceless"))
        candidates.push_back(
            {eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr),
             "EGL surfaceless", false});
    return candidates;
}

EGLContext make_current(EGLDisplay display) {
    EGLint major = 0;
    EGLint minor = 0;
    if (display == EGL_NO_DISPLAY || !eglInitialize(display, &major, &minor)) return EGL_NO_CONTEXT;
    eglBindAPI(EGL_OPENGL_API);
    const std::array<EGLint, 11> attributes = {EGL_CONTEXT_MAJOR_VERSION,
                                               4,
                                               EGL_CONTEXT_MINOR_VERSION,
                                               5,
                                               EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                               EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                               EGL_CONTEXT_OPENGL_DEBUG,
                                               EGL_TRUE,
                                               EGL_NONE};
    EGLContext context = eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes.data());
    if (context != EGL_NO_CONTEXT && !eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context)) {
        eglDestroyContext(display, context);
        context = EGL_NO_CONTEXT;
    }
    return context;
}

bool is_zink_wanted() {
    const auto names_zink = [](const char* variable) {
        const char* driver = std::getenv(variable);
        return driver && std::string_view(driver) == "zink";
    };
    return names_zink("GALLIUM_DRIVER") || names_zink("MESA_LOADER_DRIVER_OVERRIDE");
}

}  // namespace

std::string describe(const Device& device) {
    return fmt::format("{} · {} · OpenGL {} · {}{}", device.vendor, device.renderer, device.version,
                       device.route, device.software ? " (software)" : "");
}

namespace {

// Squares of the picture are drawn as points (render/blocks.h).
constexpr float largest_point = 128;

// What Talus leans on (docs/devices.md). OpenGL 4.5 promises all of it but storage blocks in vertex shaders
// and the size of points.
struct Limit {
    GLenum name;
    const char* what;
    GLint needed;
};
constexpr std::array<Limit, 11> limits = {{
    {GL_MAX_TEXTURE_SIZE, "texels along a texture's side", 16384},
    {GL_MAX_TEXTURE_IMAGE_UNITS, "textures in a fragment shader", 14},
    {GL_MAX_VERTEX_TEXTURE_IMAGE_UNITS, "textures in a vertex shader", 2},
    {GL_MAX_IMAGE_UNITS, "images that shaders write", 6},
    {GL_MAX_COMPUTE_IMAGE_UNIFORMS, "images in a compute shader", 6},
    {GL_MAX_SHADER_STORAGE_BUFFER_BINDINGS, "storage buffers at once", 6},
    {GL_MAX_COMPUTE_SHADER_STORAGE_BLOCKS, "storage buffers in a compute shader", 6},
    {GL_MAX_VERTEX_SHADER_STORAGE_BLOCKS, "storage buffers in a vertex shader", 2},
    {GL_MAX_COMPUTE_WORK_GROUP_INVOCATIONS, "invocations in a compute group", 256},
    {GL_MAX_COMPUTE_SHARED_MEMORY_SIZE, "bytes shared in a compute group", 16384},
    {GL_MAX_SHADER_STORAGE_BLOCK_SIZE, "bytes in a storage buffer", 1 << 27},
}};

}  // namespace

Device adopt_current_context(const std::string& route) {
    const int version = epoxy_gl_version();
    Device device;
    const auto text = [](GLenum name) {
        const auto* value = reinterpret_cast<const char*>(glGetString(name));
        return std::string(value ? value : "unknown");
    };
    device.vendor = text(GL_VENDOR);
    device.renderer = text(GL_RENDERER);
    device.version = text(GL_VERSION);
    device.route = route;
    device.software =
        has_word(device.renderer.c_str(), "llvmpipe") || has_word(device.renderer.c_str(), "softpipe");
    if (version < 45)
        throw Error(
            fmt::format("{} offers OpenGL {} where Talus needs 4.5", device.renderer, device.version));
    std::array<float, 2> point_sizes{};
    glGetFloatv(GL_POINT_SIZE_RANGE, point_sizes.data());
    if (point_sizes[1] < largest_point)
        throw Error(fmt::format("{} draws points of {} pixels at most where Talus needs {}", device.renderer,
                                point_sizes[1], largest_point));
    for (const Limit& limit : limits) {
        GLint given = 0;
        glGetIntegerv(limit.name, &given);
        if (given < limit.needed)
            throw Error(fmt::format("{} offers {} {} where Talus needs {}: another driver may offer more",
                                    device.renderer, given, limit.what, limit.needed));
    }
    watch_errors();
    hazards::context_made();
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glDisable(GL_DITHER);
    return device;
}

void work_around_drivers() {
    // Mesa 22.3's zink compiles programs anew for the values of uniforms that branches hang on, and confuses
    // these variants where programs take turns: a dab faded by the curve of an earlier one.
    static const bool uniforms = setenv("ZINK_INLINE_UNIFORMS", "0", 0) == 0;
    // zink does not track a buffer that Mesa packs texels into by a draw either: the next copy or read of the
    // buffer may get its old content. It does track packing by a compute shader.
    static const bool packing = !is_zink_wanted() || setenv("MESA_COMPUTE_PBO", "1", 0) == 0;
    static_cast<void>(uniforms && packing);
}

Context::Context(const ContextChoice& choice) {
    work_around_drivers();
    const std::vector<Candidate> candidates = list_candidates();
    const int count = static_cast<int>(candidates.size());
    if (choice.gpu && (*choice.gpu < 0 || *choice.gpu >= count))
        throw Error(
            fmt::format("--gpu {} names no device, there are {} (0 to {})", *choice.gpu, count, count - 1));
    std::string lacks;  // what the first device that was refused has too little of
    for (int i = 0; i < count; ++i) {
        if (choice.gpu && *choice.gpu != i) continue;
        EGLContext context = make_current(candidates[i].display);
        if (context == EGL_NO_CONTEXT) continue;
        display_ = candidates[i].display;
        context_ = context;
        bool usable = false;
        try {
            device_ = adopt_current_context(candidates[i].route);
            usable = !(choice.require_hardware && device_.software);
        } catch (const Error& error) {
            if (choice.gpu) throw;
            if (lacks.empty()) lacks = error.what();
        }
        if (usable) return;
        eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        eglDestroyContext(display_, context_);
        context_ = nullptr;
    }
    if (!lacks.empty() && !choice.require_hardware) throw Error(lacks);
    throw Error(
        choice.require_hardware
            ? "--require-hardware: no hardware device gives OpenGL 4.5 here, leave the option out to render "
              "in software"
            : "no EGL device gives OpenGL 4.5 here, install Mesa (libegl1, libgl1-mesa-dri) or a driver");
}

Context::~Context() {
    if (!context_) return;
    eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroyContext(display_, context_);
}

Context::Context(Context&& other) noexcept
    : display_(std::exchange(other.display_, nullptr)),
      context_(std::exchange(other.context_, nullptr)),
      device_(std::move(other.device_)) {}

Context& Context::operator=(Context&& other) noexcept {
    std::swap(display_, other.display_);
    std::swap(context_, other.context_);
    std::swap(device_, other.device_);
    return *this;
}

}  // namespace talus::gpu
