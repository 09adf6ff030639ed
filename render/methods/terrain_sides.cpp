#include "render/methods/terrain_sides.h"

#include <array>

#include "render/methods/cell_mesh.h"

namespace talus::render {

void TerrainSides::prepare(gpu::Program& program, const Frame& frame) {
    const Grid& grid = frame.terrain.grid();
    const unsigned edge_vertices = 12U * static_cast<unsigned>(grid.nx + grid.ny - 2);
    const std::array<std::uint32_t, 8> arguments = {edge_vertices, 1, 0, 0, 3, 1, 0, 0};
    arguments_.write(0, std::as_bytes(std::span(arguments)));
    frame.pyramid.bind(program, frame.terrain);
    set_camera(program, grid, frame.camera, frame.width, frame.height);
    program.set("near_m", near_plane_m(grid));
}

void TerrainSides::draw(const Frame& frame) {
    prepare(walls_, frame);
    walls_.draw_indirect(arguments_, 0, gpu::Depth::nearest);
    draw_below(frame);
}

void TerrainSides::draw_below(const Frame& frame) {
    prepare(below_, frame);
    below_.draw_indirect(arguments_, 4 * sizeof(std::uint32_t), gpu::Depth::nearest);
}

}  // namespace talus::render
