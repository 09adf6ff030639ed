#pragma once
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "sim/gpu/barrier.h"

namespace talus::gpu {

/// A place of a program's interface: an image, a sampler, a storage buffer or a uniform block that its
/// shaders use.
struct Place {
    Use use = Use::image;   ///< image, sampler, storage or uniforms
    std::string name;       ///< as the shader has it; of a buffer, its block's
    unsigned unit = 0;      ///< among the program's places of this use
    std::size_t bytes = 0;  ///< of a uniform block
    bool reads = true;
    bool writes = false;
    unsigned object = 0;  ///< that was bound there last
    bool bound = false;   ///< for the next run
};

/// The places that a linked program uses, each with a unit of its own, which is set in the program. `text`,
/// its shaders with their includes, says what they read and write. Throws talus::Error for a kind of place
/// that nothing can be bound to, and for a declaration that is not in one line.
std::vector<Place> places_of(unsigned program, std::string_view text);

}  // namespace talus::gpu
