#pragma once
#include <array>
#include <cstring>
#include <optional>
#include <string>
#include <utility>

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
    explicit UniformBlock(std::string label) : label_(std::move(label)) { set({}); }

    /// Dispatches before it do not see it, those after it do: other numbers get a buffer of their own, so
    /// that nothing writes one that a dispatch may still read.
    void set(const Numbers& numbers) {
        if (now_ == numbers) return;
        now_ = numbers;
        // std140 makes blocks whole multiples of 16 bytes.
        std::array<std::byte, (sizeof(Numbers) + 15) / 16 * 16> bytes{};
        std::memcpy(bytes.data(), &numbers, sizeof(Numbers));
        buffer_ = Buffer(label_, bytes);
    }
    /// For Program::bind_uniforms().
    operator const Buffer&() const { return buffer_; }

  private:
    std::string label_;
    Buffer buffer_;
    std::optional<Numbers> now_;
};

}  // namespace talus::gpu
