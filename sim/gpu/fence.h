#pragma once

namespace talus::gpu {

/// A mark in the stream of commands of the current context. It has passed when the device has done all that
/// was asked before it.
///
///     Fence fence = Fence::now();
///     if (fence.passed()) ...
class Fence {
  public:
    /// No mark.
    Fence() = default;
    static Fence now();
    ~Fence();
    Fence(Fence&& other) noexcept;
    Fence& operator=(Fence&& other) noexcept;
    Fence(const Fence&) = delete;
    Fence& operator=(const Fence&) = delete;

    explicit operator bool() const { return sync_ != nullptr; }
    /// Does not wait. The commands before it are handed to the device, so that it passes sooner or later.
    /// Throws talus::Error when the device is lost.
    bool passed() const;
    /// Waits. Not for use within a frame (law 7). Throws as passed() does.
    void wait() const;

  private:
    explicit Fence(void* sync) : sync_(sync) {}
    void* sync_ = nullptr;
};

}  // namespace talus::gpu
