#pragma once
#include <cstdint>

namespace talus {

/// Colours of screens, 0 to 255, and light, 0 to 1 (IEC 61966-2-1, "sRGB").
float from_screen(std::uint8_t colour);
/// The nearest one; light beyond 0 to 1 is cut off.
std::uint8_t to_screen(float light);

}  // namespace talus
