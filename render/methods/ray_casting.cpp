#include "render/methods/ray_casting.h"

#include "render/blocks.h"

namespace talus::render {
namespace {

#include "render/ray_kinds.glsl"
constexpr std::size_t kind_count = ray_kinds;
constexpr std::size_t draw_words = glsl::draw_words;
// A draw of each kind without a mesh, and one of each behind it.
constexpr std::size_t ray_head_words = draw_words * 2 * kind_count;

std::vector<std::string> with(std::vector<std::string> defines, bool condition, const char* define) {
    if (condition) defines.emplace_back(define);
    return defines;
}

const char* ray_shader(const RayOptions& options) {
    return options.tiled ? "render/tiled.frag" : "render/exact.frag";
}

std::vector<std::string> beam_defines(const RayOptions& options) {
    const char* const ground = options.tiled ? "tile_beam" : "whole_beam";
    return with(with({std::string("BEAM_FILE render/") + ground + ".glsl"}, options.flat_ends, "FLAT_ENDS"),
                bool(options.bind_mesh), "BEHIND_MESH");
}

}  // namespace

RayCasting::RayCasting(const RayOptions& options)
    : flat_ends_(options.flat_ends),
      bind_mesh_(options.bind_mesh),
      beams_(beam_defines(options)),
      list_({"render/ray_blocks.comp"}, with({}, bool(options.bind_mesh), "BEHIND_MESH")),
      nothing_({"render/block.vert", "render/empty.frag"}),
      walk_({"render/block.vert", ray_shader(options)}, options.defines) {
    if (options.tiled) return;
    flat_.emplace(std::vector<std::string>{"render/block.vert", "render/flat.frag"}, options.defines);
    walk_or_flat_.emplace(std::vector<std::string>{"render/block.vert", ray_shader(options)},
                          with(options.defines, options.flat_ends, "FLAT_ENDS"));
}

void RayCasting::cast_beams(const RayPicture& picture, double flatness) {
    beams_.cast(picture, flatness, bind_mesh_);
    if (picture.redraw) return;  // it has its own list
    const glm::ivec2 blocks = blocks_of(picture.size.x, picture.size.y);
    const std::size_t words = ray_head_words + kind_count * static_cast<std::size_t>(blocks.x) * blocks.y;
    if (lists_.bytes() != words * sizeof(std::uint32_t))
        lists_ = gpu::Buffer("ray blocks", words * sizeof(std::uint32_t));
    beams_.bind(list_);
    list_.bind_storage("RayBlocks", lists_);
    if (bind_mesh_) bind_mesh_(list_);
    list_.set("blocks", blocks);
    list_.set("beam_count", Beams::count(picture.size));
    list_.dispatch(1);
    gpu::barrier({gpu::Use::storage, gpu::Use::indirect});
}

void RayCasting::draw(const RayPicture& picture) {
    const gpu::Depth depth = bind_mesh_ ? gpu::Depth::behind : gpu::Depth::none;
    const auto prepare = [&](gpu::Program& program) {
        picture.bind(program);
        beams_.bind(program);
    };
    if (picture.redraw) {
        prepare(*walk_or_flat_);
        picture.redraw->draw(*walk_or_flat_, picture.hits, depth);
        return;
    }
    const glm::ivec2 blocks = blocks_of(picture.size.x, picture.size.y);
    const std::array<gpu::Program*, kind_count> programs = {&nothing_, flat_ ? &*flat_ : nullptr, &walk_,
                                                            walk_or_flat_ ? &*walk_or_flat_ : nullptr};
    for (std::size_t kind = 0; kind < kind_count; ++kind) {
        if (!flat_ends_ && (kind == kind_flat || kind == kind_walk_or_flat)) continue;
        prepare(*programs[kind]);
        const std::size_t numbers = ray_head_words + kind * static_cast<std::size_t>(blocks.x) * blocks.y;
        draw_blocks(*programs[kind], picture.hits, picture.size, {lists_, draw_words * kind, numbers},
                    gpu::Depth::none);
        if (!bind_mesh_) continue;
        prepare(*programs[kind]);
        draw_blocks(*programs[kind], picture.hits, picture.size,
                    {lists_, draw_words * (kind_count + kind), numbers}, gpu::Depth::behind);
    }
}

RayPicture ray_picture(const Frame& frame) {
    return {{frame.width, frame.height},
            frame.hits,
            [&frame](gpu::Program& program) {
                frame.pyramid.bind(program, frame.terrain);
                set_camera(program, frame.terrain.grid(), frame.camera, frame.width, frame.height);
            },
            frame.redraw};
}

Method cast_rays(const std::vector<std::string>& defines) {
    auto rays = std::make_shared<RayCasting>(RayOptions{defines});
    const auto draw = [rays](const Frame& frame) {
        const RayPicture picture = ray_picture(frame);
        rays->cast_beams(picture);
        if (frame.redraw) frame.redraw->list();
        rays->draw(picture);
    };
    return {draw, [rays] { return MethodFigures{0, 0, rays->bytes()}; }};
}

}  // namespace talus::render
