#pragma once
#include "render/methods/method.h"

namespace talus::render {

/// Triangles over listed square cells of the terrain, two a patch, by displaced vertices at full resolution.
class CellMesh {
  public:
    /// Cells of this many patches in a row and a column.
    void resize(int cell_patches);
    int indices_per_cell() const { return 6 * cell_patches_ * cell_patches_; }

    /// Draws the nearest into the frame's hits. cells: the arguments of the draw, five words of eight, then
    /// the cells' numbers (row x columns + column); columns: cells in a row of the terrain.
    void draw(const Frame& frame, const gpu::Buffer& cells, int columns);

    std::size_t bytes() const { return indices_.bytes(); }

  private:
    gpu::Program program_{std::vector<std::string>{"render/mesh.vert", "render/mesh.frag"}};
    gpu::Buffer indices_;
    int cell_patches_ = 0;
};

/// Indices of two triangles a patch of such a cell, whose vertices are numbered row by row. The diagonal goes
/// from north-east to south-west.
gpu::Buffer cell_indices(int cell_patches);

/// Depth along the view where the depth buffer has 1: a thousandth of a sample.
float near_plane_m(const Grid& grid);

}  // namespace talus::render
