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
///     };
template <typename Numbers>
class UniformBlock {
  public:
    explicit UniformBlock(std::string label) : label_(std::move(label)) { set({}); }

    /// Only later dispatches see the numbers. Changed numbers get a new buffer, so that no buffer is written
    /// that an earlier dispatch may still read.
    void set(const Numbers& numbers) {
        Bytes bytes{};
        std::memcpy(bytes.data(), &numbers, sizeof(Numbers));
        // By their bytes: -0 is not 0.
        if (now_ == bytes) return;
        now_ = bytes;
        buffer_ = Buffer(label_, bytes);
    }
    /// For Program::bind_uniforms().
    operator const Buffer&() const { return buffer_; }

  private:
    // std140 makes blocks whole multiples of 16 bytes.
    using Bytes = std::array<std::byte, (sizeof(Numbers) + 15) / 16 * 16>;

    std::string label_;
    Buffer buffer_;
    std::optional<Bytes> now_;
};

}  // namespace talus::gpu
