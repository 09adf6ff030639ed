#include "sim/gpu/fence.h"

#include <epoxy/gl.h>

#include <utility>

#include "sim/gpu/error.h"

namespace talus::gpu {
namespace {

constexpr GLuint64 nanoseconds_a_minute = 60'000'000'000;

bool wait_for(void* sync, GLuint64 nanoseconds) {
    const GLenum state = glClientWaitSync(static_cast<GLsync>(sync), GL_SYNC_FLUSH_COMMANDS_BIT, nanoseconds);
    return state == GL_ALREADY_SIGNALED || state == GL_CONDITION_SATISFIED;
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
    return wait_for(sync_, 0);
}

void Fence::wait() const {
    if (!wait_for(sync_, nanoseconds_a_minute))
        throw Error(
            "the graphics device did not finish its work within a minute: restart Talus, and look for a "
            "newer driver");
}

}  // namespace talus::gpu
