#include "sim/gpu/fence.h"

#include <epoxy/gl.h>

#include <utility>

#include "sim/error.h"

namespace talus::gpu {
namespace {

constexpr GLuint64 nanoseconds_a_second = 1'000'000'000;

// Whether it passed within that time. Throws talus::Error where it never will.
bool passes_within(void* sync, GLuint64 nanoseconds) {
    const GLenum state = glClientWaitSync(static_cast<GLsync>(sync), GL_SYNC_FLUSH_COMMANDS_BIT, nanoseconds);
    if (state == GL_WAIT_FAILED)
        throw Error("the graphics device does not answer any more: save what you can, and start Talus again");
    return state != GL_TIMEOUT_EXPIRED;
}

}  // namespace

Fence Fence::now() {
    return Fence(glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0));
}

Fence::~Fence() {
    if (sync_) glDeleteSync(static_cast<GLsync>(sync_));
}

Fence::Fence(Fence&& other) noexcept : sync_(std::exchange(other.sync_, nullptr)) {}

Fence& Fence::operator=(Fence&& other) noexcept {
    std::swap(sync_, other.sync_);
    return *this;
}

bool Fence::passed() const {
    return passes_within(sync_, 0);
}

void Fence::wait() const {
    // However long: a run may have asked for hours of work.
    while (!passes_within(sync_, nanoseconds_a_second)) {
    }
}

}  // namespace talus::gpu
