#include "sim/passes/stamp_image.h"

#include <span>

namespace talus {

const gpu::Texture& StampImage::of(const std::shared_ptr<const Stamp>& stamp) {
    if (there_ != stamp) {
        texture_ = gpu::Texture("stamp", gpu::Format::r32f, stamp->grid.nx, stamp->grid.ny);
        texture_.write(texture_.whole(), std::as_bytes(std::span(stamp->heights)));
        there_ = stamp;
    }
    return texture_;
}

}  // namespace talus
