#include "render/methods/cell_mesh.h"
#include "render/methods/method.h"
#include "render/methods/terrain_sides.h"

namespace talus::render {
namespace {

// Cells of 32 x 32 patches, or the coarsest that the pyramid of a small terrain has.
constexpr int mesh_cell_level = 5;

struct MeshMethod {
    gpu::Program list{"render/mesh_cells.comp"};
    CellMesh mesh;
    TerrainSides sides;
    gpu::Buffer cells;
};

void draw(MeshMethod& method, const Frame& frame) {
    const Grid& grid = frame.terrain.grid();
    const int level = std::min(mesh_cell_level, frame.pyramid.top_level());
    const glm::ivec2 size = frame.pyramid.level_1_size() >> (level - 1);
    method.mesh.resize(1 << level);
    const std::size_t bytes = (8 + static_cast<std::size_t>(size.x) * size.y) * sizeof(std::uint32_t);
    if (method.cells.bytes() != bytes) method.cells = gpu::Buffer("mesh cells", bytes);
    const std::array<std::uint32_t, 8> arguments = {
        static_cast<std::uint32_t>(method.mesh.indices_per_cell()), 0, 0, 0, 0, 0, 0, 0};
    method.cells.write(0, std::as_bytes(std::span(arguments)));
    frame.pyramid.bind(method.list, frame.terrain);
    method.list.bind_storage("MeshCells", method.cells);
    set_camera(method.list, grid, frame.camera, frame.width, frame.height);
    method.list.set("cell_level", level);
    method.list.dispatch((size.x * size.y + 63) / 64);
    gpu::barrier({gpu::Use::storage, gpu::Use::indirect, gpu::Use::buffer_transfer});
    frame.hits.clear(0, {HUGE_VALF, 0, 0, 0});
    frame.hits.clear_depth();
    frame.hits.bind({0, 0, frame.width, frame.height});
    method.mesh.draw(frame, method.cells, size.x);
    method.sides.draw(frame);
}

}  // namespace

std::vector<PixelKind> mesh_kinds(const OwnNumbers&) {
    return {{1, "mesh"}};
}

Method make_mesh(Detail) {
    auto mesh = std::make_shared<MeshMethod>();
    const auto figures = [mesh] {
        MethodFigures result;
        if (mesh->cells.bytes() > 0) {
            const auto words = mesh->cells.read_all<std::uint32_t>();
            result.mesh_cells = static_cast<int>(words[1]);
            result.triangles = static_cast<long>(words[0] / 3) * result.mesh_cells;
        }
        result.bytes = mesh->cells.bytes() + mesh->mesh.bytes();
        return result;
    };
    return {[mesh](const Frame& frame) { draw(*mesh, frame); }, figures};
}

}  // namespace talus::render
