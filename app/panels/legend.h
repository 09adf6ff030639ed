#pragma once
#include <vector>

#include "render/view.h"
#include "sim/gpu/texture.h"

namespace talus {

/// Adds the legends to the present ImGui frame, in the lower right corner of a display of this size.
void draw_legend(const std::vector<Legend>& legends, int width, int height);

/// Draws the legends of a picture of this size into the framebuffer of one of its tiles (corner from the
/// upper left), where no window is: as the window shows them.
void draw_legend_into(const gpu::Framebuffer& framebuffer, glm::ivec2 size, glm::ivec2 corner,
                      glm::ivec2 tile, const std::vector<Legend>& legends);

/// Loads the font that panels and legends are set in; a sans serif of the system, or ImGui's own where there
/// is none.
void load_font(float pixels);

}  // namespace talus
