#pragma once
#include <utility>

namespace talus::gpu {

/// An OpenGL name that is deleted with its owner: moved, never copied. 0 is no object.
template <void (*Delete)(unsigned)>
class Handle {
  public:
    Handle() = default;
    explicit Handle(unsigned name) : name_(name) {}
    ~Handle() {
        if (name_) Delete(name_);
    }
    Handle(Handle&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
    Handle& operator=(Handle&& other) noexcept {
        std::swap(name_, other.name_);
        return *this;
    }
    Handle(const Handle&) = delete;
    Handle& operator=(const Handle&) = delete;
    operator unsigned() const { return name_; }

  private:
    unsigned name_ = 0;
};

}  // namespace talus::gpu
