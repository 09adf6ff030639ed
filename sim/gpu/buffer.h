#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "sim/gpu/handle.h"

namespace talus::gpu {

void delete_buffer(unsigned name);

/// An offset into a bound buffer, bytes, as OpenGL's interface takes it: as a pointer.
inline void* as_offset(std::size_t bytes) {
    return reinterpret_cast<void*>(bytes);  // NOLINT(performance-no-int-to-ptr)
}

/// Memory on the device, of a fixed size. The label shows in debuggers and error messages.
///
///     Buffer flags("tile flags", count * sizeof(std::uint32_t));
///     flags.fill(1);
///     program.bind_storage("Flags", flags);
class Buffer {
  public:
    Buffer() = default;
    Buffer(const std::string& label, std::size_t bytes);
    /// Of these bytes, for ever: no call writes it.
    Buffer(const std::string& label, std::span<const std::byte> data);

    std::size_t bytes() const { return bytes_; }
    unsigned name() const { return handle_; }

    /// Sets every 32-bit word to the value.
    void fill(std::uint32_t word);
    /// In its turn: dispatches before it do not see it, those after it do. Each call makes a buffer for the
    /// bytes, and drops it.
    void write(std::size_t offset, std::span<const std::byte> data);
    /// Waits for the device. Not for use within a frame (law 7).
    void read(std::size_t offset, std::span<std::byte> data) const;
    /// The same where a fence behind the last write has passed: nothing is waited for.
    void read_passed(std::size_t offset, std::span<std::byte> data) const;

    template <typename T>
    void write_all(const std::vector<T>& values) {
        write(0, std::as_bytes(std::span(values)));
    }
    template <typename T>
    std::vector<T> read_all() const {
        std::vector<T> values(bytes_ / sizeof(T));
        read(0, std::as_writable_bytes(std::span(values)));
        return values;
    }

    /// Device to device, without waiting: all bytes of a buffer of the same size.
    void copy_from(const Buffer& other);
    /// The same for so many bytes of another buffer, each at its own offset.
    void copy_part(std::size_t offset, const Buffer& other, std::size_t other_offset, std::size_t bytes);

    /// Where a program finds it; Program's calls of the same names know the index.
    void bind_storage(unsigned index) const;
    void bind_uniforms(unsigned index) const;

  private:
    Handle<delete_buffer> handle_;
    std::size_t bytes_ = 0;
};

}  // namespace talus::gpu
