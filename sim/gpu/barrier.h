#pragma once
#include <initializer_list>

namespace talus::gpu {

/// How what shaders stored into images and buffers is used next.
enum class Use : unsigned {
    image = 0,         ///< loaded or stored as an image by shaders
    sampler,           ///< fetched through a sampler
    storage,           ///< read or written as a storage buffer
    indirect,          ///< arguments of an indirect dispatch or draw
    elements,          ///< indices of a draw
    texture_transfer,  ///< a texture copied, written or read by a call (Texture::read, copy_from …)
    buffer_transfer,   ///< a buffer copied, filled, written or read by a call
    pixel_buffer,      ///< a buffer that texels are packed into or unpacked from
    framebuffer,       ///< drawn into, cleared or blitted as a target
    uniforms,          ///< read as a uniform block
};
constexpr unsigned use_count = 10;

/// Draws, copies and calls are in order by themselves. What shaders store is not: it is there for a use only
/// after a barrier that names the use. A debug build throws where one is missing (sim/gpu/hazards.h).
void barrier(std::initializer_list<Use> uses);

}  // namespace talus::gpu
