#include "render/methods/ray_casting.h"

namespace talus::render {

Method make_exact(Detail detail) {
    return cast_rays(detail_defines(detail));
}

}  // namespace talus::render
