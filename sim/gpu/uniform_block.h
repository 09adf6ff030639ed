#pragma once
#include <optional>
#include <string>

#include "sim/gpu/buffer.h"

namespace talus::gpu {

/// A uniform block on the device. `Numbers` is a struct of the lines that the shader's block has too, one
/// NUMBER(type, name) each (shaders/maths/twin.h):
///
///     struct ThermalNumbers {
///         TALUS_TWIN_NAMES(float)
///     #define NUMBER TALUS_MEMBER
///     #include "maths/thermal_numbers.glsl"
///     #undef NUMBER
///         bool operator==(const ThermalNumbers&) const = default;
///     };
template <typename Numbers>
class UniformBlock {
  public:
    // std140 makes blocks whole multiples of 16 bytes.
    explicit UniformBlock(const std::string& label) : buffer_(label, (sizeof(Numbers) + 15) / 16 * 16) {}

    /// In its turn: dispatches before it do not see it, those after it do. Writes where the numbers are
    /// others.
    void set(const Numbers& numbers) {
        if (now_ == numbers) return;
        now_ = numbers;
        buffer_.write(0, std::as_bytes(std::span(&numbers, 1)));
    }
    /// For Program::bind_uniforms().
    operator const Buffer&() const { return buffer_; }

  private:
    Buffer buffer_;
    std::optional<Numbers> now_;
};

}  // namespace talus::gpu
