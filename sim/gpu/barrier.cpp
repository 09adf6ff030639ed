#include "sim/gpu/barrier.h"

#include <epoxy/gl.h>

#include <array>

#include "sim/gpu/hazards.h"

namespace talus::gpu {

void barrier(std::initializer_list<Use> uses) {
    constexpr std::array<GLbitfield, use_count> bits = {
        GL_SHADER_IMAGE_ACCESS_BARRIER_BIT, GL_TEXTURE_FETCH_BARRIER_BIT,
        GL_SHADER_STORAGE_BARRIER_BIT,      GL_COMMAND_BARRIER_BIT,
        GL_ELEMENT_ARRAY_BARRIER_BIT,       GL_TEXTURE_UPDATE_BARRIER_BIT,
        GL_BUFFER_UPDATE_BARRIER_BIT,       GL_PIXEL_BUFFER_BARRIER_BIT,
        GL_FRAMEBUFFER_BARRIER_BIT,         GL_UNIFORM_BARRIER_BIT};
    GLbitfield all = 0;
    for (const Use use : uses) all |= bits[static_cast<unsigned>(use)];
    glMemoryBarrier(all);
    for (const Use use : uses) hazards::ordered(use);
}

}  // namespace talus::gpu
