#pragma once
#include <vector>

#include "app/core/legend.h"

namespace talus::app {

/// Adds the legends to the present ImGui frame, in the lower right corner of a display of this size.
void draw_legend(const std::vector<render::Legend>& legends, int width, int height);

/// Loads the font that panels and legends are set in; a sans serif of the system, or ImGui's own where there
/// is none.
void load_font(float pixels);

}  // namespace talus::app
