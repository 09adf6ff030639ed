#pragma once

namespace talus {

/// How panels look, at this scale; loads their font.
void set_style(float scale);

}  // namespace talus
