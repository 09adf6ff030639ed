#include "render/redraw.h"

#include <array>

#include "render/blocks.h"

namespace talus::render {
Redraw::Redraw() : mark_("render/redraw_mark.comp"), list_("render/redraw_list.comp") {}

void Redraw::begin(int width, int height) {
    width_ = width;
    height_ = height;
    blocks_ = blocks_of(width, height);
    const std::size_t bytes =
        (glsl::draw_words + static_cast<std::size_t>(blocks_.x) * blocks_.y) * sizeof(std::uint32_t);
    if (marks_.bytes() != bytes) {
        marks_ = gpu::Buffer("redraw marks", bytes);
        listed_ = gpu::Buffer("redraw blocks", bytes);
    }
    marks_.fill(0);
}

void Redraw::bind(gpu::Program& program) const {
    program.bind_storage("RedrawMarks", marks_);
    program.set("blocks", blocks_);
}

void Redraw::mark(bool after, const TileList& tiles, const Terrain& terrain, const Pyramid& pyramid,
                  const Camera& camera, glm::dvec3 sun, int reach) {
    mark_.set("shading_reach", reach);
    mark_.set("after", after ? 1 : 0);
    pyramid.bind(mark_, terrain);
    set_camera(mark_, terrain.grid(), camera, width_, height_);
    mark_.set("tiles", glm::ivec2(terrain.tiles.columns(), terrain.tiles.rows()));
    mark_.set("sun", glm::vec3(sun));
    bind(mark_);
    mark_.bind_storage("TileList", tiles.buffer);
    mark_.dispatch_indirect(tiles.buffer);
    gpu::barrier({gpu::Use::storage, gpu::Use::buffer_transfer});
}

void Redraw::list() {
    const std::array<std::uint32_t, glsl::draw_words> arguments = {0, 1, 0, 0};
    listed_.write(0, std::as_bytes(std::span(arguments)));
    bind(list_);
    list_.bind_storage("Blocks", listed_);
    list_.dispatch((blocks_.x * blocks_.y + 63) / 64);
    gpu::barrier({gpu::Use::storage, gpu::Use::indirect, gpu::Use::buffer_transfer});
}

void Redraw::draw(gpu::Program& program, const gpu::Framebuffer& target, gpu::Depth depth) const {
    draw_blocks(program, target, {width_, height_}, {listed_, 0, glsl::draw_words}, depth);
}

}  // namespace talus::render
