#include "render/methods/cells_in_view.h"

#include <array>

namespace talus::render {
namespace {

constexpr int most_level = 5;

}  // namespace

int CellsInView::level(const Frame& frame) {
    return std::min(most_level, frame.pyramid.top_level());
}

void CellsInView::list(const Frame& frame, int vertices) {
    const glm::ivec2 size = frame.pyramid.level_1_size() >> (level(frame) - 1);
    const std::size_t bytes = (8 + static_cast<std::size_t>(size.x) * size.y) * sizeof(std::uint32_t);
    if (cells_.bytes() != bytes) cells_ = gpu::Buffer("mesh cells", bytes);
    const std::array<std::uint32_t, 8> arguments = {
        static_cast<std::uint32_t>(vertices), 0, 0, 0, 0, 0, 0, 0};
    cells_.write(0, std::as_bytes(std::span(arguments)));
    frame.pyramid.bind(program_, frame.terrain);
    program_.bind_storage("MeshCells", cells_);
    set_camera(program_, frame.terrain.grid(), frame.camera, frame.width, frame.height);
    program_.set("cell_level", level(frame));
    program_.dispatch((size.x * size.y + 63) / 64);
    gpu::barrier({gpu::Use::storage, gpu::Use::indirect, gpu::Use::buffer_transfer});
}

MethodFigures CellsInView::figures() const {
    MethodFigures result;
    if (cells_.bytes() == 0) return result;
    const auto words = cells_.read_all<std::uint32_t>();
    result.mesh_cells = static_cast<int>(words[1]);
    result.triangles = static_cast<long>(words[0] / 3) * result.mesh_cells;
    result.bytes = cells_.bytes();
    return result;
}

}  // namespace talus::render
