#pragma once

namespace talus::app {

/// How panels look, at this scale; loads their font.
void set_style(float scale);

}  // namespace talus::app
