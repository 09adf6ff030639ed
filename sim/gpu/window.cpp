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

}  // namespace talus::gpu
