#pragma once
#include <optional>
#include <string>
#include <vector>

namespace talus::gpu {

/// What an OpenGL context runs on.
struct Device {
    std::string vendor;
    std::string renderer;
    std::string version;
    std::string route;      ///< how the context was made, e.g. "EGL device 0" or "window"
    bool software = false;  ///< true for llvmpipe and its like
};

/// One line for people: vendor, renderer, version and route.
std::string describe(const Device& device);

/// Which device a headless context should take.
struct ContextChoice {
    std::optional<int> gpu;         ///< position in the list, hardware first; none: the first that works
    bool require_hardware = false;  ///< refuse software renderers
};

/// Before a first context is made, here or by a window: turns off what a driver is known to do wrong
/// (docs/devices.md), as far as the environment does not say otherwise.
void work_around_drivers();

/// A headless OpenGL 4.5 core context, current on the thread that made it for as long as it lives.
/// EGL devices are enumerated, hardware first; then EGL's surfaceless platform is tried.
/// Throws talus::Error when none gives OpenGL 4.5.
class Context {
  public:
    explicit Context(const ContextChoice& choice = {});
    ~Context();
    Context(Context&& other) noexcept;
    Context& operator=(Context&& other) noexcept;
    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;

    const Device& device() const { return device_; }

  private:
    void* display_ = nullptr;
    void* context_ = nullptr;
    Device device_;
};

/// Describes the context that a window made current and turns its error checks on.
/// Throws talus::Error when it is below OpenGL 4.5.
Device adopt_current_context(const std::string& route);

}  // namespace talus::gpu
