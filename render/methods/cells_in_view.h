#pragma once
#include "render/methods/method.h"

namespace talus::render {

/// Lists the cells of the pyramid, of 32 x 32 patches, that the view may show, on the device.
class CellsInView {
  public:
    /// vertices: of a cell, for the arguments of the draw.
    void list(const Frame& frame, int vertices);

    /// Of the cells. A small terrain's pyramid has no coarser ones.
    static int level(const Frame& frame);
    /// In a row.
    static int columns(const Frame& frame) { return frame.pyramid.level_1_size().x >> (level(frame) - 1); }

    /// The arguments of a draw, eight words: vertices, then instances; then the cells' numbers.
    const gpu::Buffer& listed() const { return cells_; }
    MethodFigures figures() const;

  private:
    gpu::Program program_{"render/mesh_cells.comp"};
    gpu::Buffer cells_;
};

}  // namespace talus::render
