#include "sim/gpu/readback.h"

#include <epoxy/gl.h>

#include <utility>

#include "sim/gpu/debug.h"

namespace talus::gpu {

void Readback::cancel() {
    fence_ = Fence();
}

void Readback::start(const Texture& texture, const Region& region) {
    const std::size_t bytes =
        static_cast<std::size_t>(region.width) * region.height * texel_bytes(texture.format());
    if (buffer_.bytes() != bytes) buffer_ = Buffer("readback", bytes);
    texture.copy_to(buffer_, 0, region);
    fence_ = Fence::now();
    raise_errors();
}

void Readback::start(const Buffer& buffer, std::size_t bytes) {
    if (buffer_.bytes() != bytes) buffer_ = Buffer("readback", bytes);
    buffer_.copy_part(0, buffer, 0, bytes);
    fence_ = Fence::now();
    raise_errors();
}

void Readback::start(Buffer&& buffer) {
    buffer_ = std::move(buffer);
    owned_ = true;
    fence_ = Fence::now();
    raise_errors();
}

std::optional<std::vector<float>> Readback::poll() {
    if (!fence_ || !fence_.passed()) return std::nullopt;
    return take();
}

std::vector<float> Readback::wait() {
    fence_.wait();
    return take();
}

std::vector<float> Readback::take() {
    cancel();
    std::vector<float> words(buffer_.bytes() / sizeof(float));
    buffer_.read_passed(0, std::as_writable_bytes(std::span(words)));
    if (owned_) buffer_ = Buffer();
    owned_ = false;
    return words;
}

}  // namespace talus::gpu
