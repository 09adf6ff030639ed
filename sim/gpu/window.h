#pragma once
#include "sim/gpu/buffer.h"
#include "sim/gpu/region.h"

namespace talus::gpu {

/// Draws go to this region of the window of the current context, rows from below.
void bind_window(const Region& viewport);
/// The same, and they change its depth alone, until the next bind_window().
void bind_window_depth(const Region& viewport);

/// Draws from here on, of whatever library, lie at this depth (1 near, 0 far), and show only where the
/// window's depth is no nearer; they leave it as it is.
void draw_at_depth(float depth);
/// Draws show everywhere again.
void draw_without_depth();

/// What was drawn into this region of the window since it was presented last: RGBA, 8 bits each, rows from
/// below. Does not wait.
Buffer copy_window(const Region& region);

}  // namespace talus::gpu
