#pragma once

namespace talus::gpu {

/// A rectangle of texels: corner, size.
struct Region {
    int x = 0;
    int y = 0;
    int width = 0;
    int height = 0;
};

}  // namespace talus::gpu
