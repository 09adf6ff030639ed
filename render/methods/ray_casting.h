#pragma once
#include "render/methods/method.h"

namespace talus {

/// A method that casts a ray for every pixel: shaders/render/exact.frag with defines, from where beams end.
Method cast_rays(const std::vector<std::string>& defines);

}  // namespace talus
