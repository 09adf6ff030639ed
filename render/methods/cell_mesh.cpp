#include "render/methods/cell_mesh.h"

namespace talus::render {

gpu::Buffer cell_indices(int cell_patches) {
    const auto patches = static_cast<unsigned>(cell_patches);
    const unsigned side = patches + 1;
    std::vector<std::uint32_t> indices;
    indices.reserve(std::size_t{6} * patches * patches);
    for (unsigned y = 0; y < patches; ++y)
        for (unsigned x = 0; x < patches; ++x) {
            const unsigned at = y * side + x;
            indices.insert(indices.end(), {at, at + side, at + 1, at + 1, at + side, at + side + 1});
        }
    gpu::Buffer buffer("cell indices", indices.size() * sizeof(std::uint32_t));
    buffer.write_all(indices);
    return buffer;
}

void CellMesh::resize(int cell_patches) {
    if (cell_patches == cell_patches_) return;
    indices_ = cell_indices(cell_patches);
    cell_patches_ = cell_patches;
}

void CellMesh::draw(const Frame& frame, const gpu::Buffer& cells, int columns) {
    const Grid& grid = frame.terrain.grid();
    frame.pyramid.bind(program_, frame.terrain);
    program_.bind_storage("MeshCells", cells);
    set_camera(program_, grid, frame.camera, frame.width, frame.height);
    program_.set("cell_patches", cell_patches_);
    program_.set("cell_columns", columns);
    program_.set("near_m", near_plane_m(grid));
    program_.draw_indexed_indirect(indices_, cells, 0, gpu::Depth::nearest);
}

float near_plane_m(const Grid& grid) {
    return static_cast<float>(1e-3 * std::min(grid.dx, grid.dy));
}

}  // namespace talus::render
