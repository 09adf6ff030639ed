#include "render/methods/beams.h"

namespace talus::render {
namespace {

#include "render/beam_pixels.glsl"

}  // namespace

glm::ivec2 Beams::count(glm::ivec2 picture) {
    return (picture + beam_pixels - 1) / beam_pixels;
}

Beams::Beams(const std::vector<std::string>& defines)
    : program_({"render/fullscreen.vert", "render/beam.frag"}, defines),
      changes_("render/beam_changes.comp") {}

void Beams::cast(const RayPicture& picture, double flatness, const std::function<void(gpu::Program&)>& bind) {
    const glm::ivec2 size = count(picture.size);
    newest_ = 1 - newest_;
    Set& set = sets_[newest_];
    if (set.texture.width() < size.x || set.texture.height() < size.y) {
        set.texture = gpu::Texture("beams", gpu::Format::rg32f, std::max(size.x, set.texture.width()),
                                   std::max(size.y, set.texture.height()));
        const std::array<const gpu::Texture*, 1> colours = {&set.texture};
        set.buffer = gpu::Framebuffer("beams", colours);
    }
    picture.bind(program_);
    if (bind) bind(program_);
    program_.set("flatness", static_cast<float>(flatness));
    set.buffer.bind({0, 0, size.x, size.y});
    program_.draw_fullscreen();
}

void Beams::mark_changes(const RayPicture& picture) {
    const glm::ivec2 size = count(picture.size);
    changes_.bind_sampled("beams_now", sets_[newest_].texture);
    changes_.bind_sampled("beams_before", sets_[1 - newest_].texture);
    picture.redraw->bind(changes_);
    changes_.set("beam_count", size);
    changes_.dispatch((size.x + 15) / 16, (size.y + 15) / 16);
    gpu::barrier({gpu::Use::storage});
}

std::size_t Beams::bytes() const {
    std::size_t sum = 0;
    for (const Set& set : sets_)
        sum += gpu::texel_bytes(gpu::Format::rg32f) * static_cast<std::size_t>(set.texture.width()) *
               static_cast<std::size_t>(set.texture.height());
    return sum;
}

}  // namespace talus::render
