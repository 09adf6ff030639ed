#include "sim/gpu/window.h"

#include <epoxy/gl.h>

#include "sim/gpu/debug.h"
#include "sim/gpu/hazards.h"

namespace talus::gpu {

void bind_window(const Region& viewport) {
    hazards::bound_targets({});
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    // A clip of the last target would cut copies onto the window too.
    glDisable(GL_SCISSOR_TEST);
    glViewport(viewport.x, viewport.y, viewport.width, viewport.height);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

void bind_window_depth(const Region& viewport) {
    bind_window(viewport);
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
}

void draw_at_depth(float depth) {
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_GEQUAL);
    glDepthMask(GL_FALSE);
    // Whatever depth the vertices have.
    glDepthRangef(depth, depth);
}

void draw_without_depth() {
    glDisable(GL_DEPTH_TEST);
    glDepthMask(GL_TRUE);
    glDepthRangef(0, 1);
}

Buffer copy_window(const Region& region) {
    Buffer pixels("window pixels", static_cast<std::size_t>(region.width) * region.height * 4);
    hazards::used(hazards::Kind::buffer, pixels.name(), Use::pixel_buffer, "copy_window");
    glBindFramebuffer(GL_READ_FRAMEBUFFER, 0);
    glBindBuffer(GL_PIXEL_PACK_BUFFER, pixels.name());
    glReadPixels(region.x, region.y, region.width, region.height, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
    raise_errors();
    return pixels;
}

}  // namespace talus::gpu
