#include "render/hits_target.h"

#include <glm/glm.hpp>

namespace talus::render {
namespace {

std::vector<float> read_component(const gpu::Texture& hits, int width, int height, int component) {
    std::vector<glm::vec2> texels(static_cast<std::size_t>(width) * height);
    hits.read({0, 0, width, height}, std::as_writable_bytes(std::span(texels)));
    std::vector<float> values;
    values.reserve(texels.size());
    for (const glm::vec2 texel : texels) values.push_back(texel[component]);
    return values;
}

}  // namespace

HitsTarget::HitsTarget(int width, int height)
    : hits_("hits", gpu::Format::rg32f, width, height),
      depth_("depth", gpu::Format::depth32f, width, height) {
    const std::array<const gpu::Texture*, 1> colours = {&hits_};
    framebuffer_ = gpu::Framebuffer("hits", colours, &depth_);
}

std::size_t HitsTarget::bytes() const {
    const std::size_t texels = static_cast<std::size_t>(hits_.width()) * hits_.height();
    return texels * (gpu::texel_bytes(gpu::Format::rg32f) + gpu::texel_bytes(gpu::Format::depth32f));
}

std::vector<float> HitsTarget::read_distances(int width, int height) const {
    return read_component(hits_, width, height, 0);
}

std::vector<float> HitsTarget::read_details(int width, int height) const {
    return read_component(hits_, width, height, 1);
}

}  // namespace talus::render
