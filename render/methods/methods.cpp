#include "render/methods/method.h"

namespace talus {

const std::vector<MethodEntry>& methods() {
    static const std::vector<MethodEntry> entries = {
        {"exact", "a ray per pixel through the pyramid onto the bilinear surface", make_exact},
    };
    return entries;
}

}  // namespace talus
