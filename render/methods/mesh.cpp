#include "render/methods/method.h"

namespace talus::render {
namespace {

// Cells of 32 x 32 patches, or the coarsest that the pyramid of a small terrain has.
constexpr int mesh_cell_level = 5;

gpu::Buffer cell_indices(int level) {
    const unsigned patches = 1U << static_cast<unsigned>(level);
    const unsigned side = patches + 1;
    std::vector<std::uint32_t> indices;
    for (unsigned y = 0; y < patches; ++y)
        for (unsigned x = 0; x < patches; ++x) {
            const unsigned at = y * side + x;
            indices.insert(indices.end(), {at, at + side, at + 1, at + 1, at + side, at + side + 1});
        }
    gpu::Buffer buffer("cell indices", indices.size() * sizeof(std::uint32_t));
    buffer.write_all(indices);
    return buffer;
}

struct MeshMethod {
    gpu::Program list{"render/mesh_cells.comp"};
    gpu::Program draw{std::vector<std::string>{"render/mesh.vert", "render/mesh.frag"}};
    gpu::Program walls{std::vector<std::string>{"render/mesh_walls.vert", "render/mesh.frag"}, {"WALLS"}};
    gpu::Program below{std::vector<std::string>{"render/mesh_below.vert", "render/mesh_below.frag"}};
    gpu::Buffer edges{"edge arguments", 8 * sizeof(std::uint32_t)};
    gpu::Buffer indices;
    gpu::Buffer cells;
    int level = 0;
};

}  // namespace

Method make_mesh(Detail) {
    auto mesh = std::make_shared<MeshMethod>();
    const auto draw = [mesh](const Frame& frame) {
        const Grid& grid = frame.terrain.grid();
        const int level = std::min(mesh_cell_level, frame.pyramid.top_level());
        const glm::ivec2 size = frame.pyramid.level_1_size() >> (level - 1);
        if (level != mesh->level) mesh->indices = cell_indices(level);
        mesh->level = level;
        const std::size_t bytes = (8 + static_cast<std::size_t>(size.x) * size.y) * sizeof(std::uint32_t);
        if (mesh->cells.bytes() != bytes) mesh->cells = gpu::Buffer("mesh cells", bytes);
        const std::array<std::uint32_t, 8> arguments = {
            6U << (2U * static_cast<unsigned>(level)), 0, 0, 0, 0, 0, 0, 0};
        mesh->cells.write(0, std::as_bytes(std::span(arguments)));
        const auto near_m = static_cast<float>(1e-3 * std::min(grid.dx, grid.dy));
        const auto prepare = [&](gpu::Program& program) {
            frame.pyramid.bind(program, frame.terrain);
            program.bind_storage("MeshCells", mesh->cells);
            set_camera(program, grid, frame.camera, frame.width, frame.height);
            program.set("cell_level", level);
            program.set("near_m", near_m);
        };
        prepare(mesh->list);
        mesh->list.dispatch((size.x * size.y + 63) / 64);
        gpu::barrier({gpu::Use::storage, gpu::Use::indirect, gpu::Use::buffer_transfer});
        const gpu::Region picture{0, 0, frame.width, frame.height};
        frame.hits.clear(0, {HUGE_VALF, 0, 0, 0});
        frame.hits.clear_depth();
        frame.hits.bind(picture);
        prepare(mesh->draw);
        mesh->draw.draw_indexed_indirect(mesh->indices, mesh->cells, 0, gpu::Depth::nearest);
        const unsigned edge_vertices = 12U * static_cast<unsigned>(grid.nx + grid.ny - 2);
        const std::array<std::uint32_t, 8> edges = {edge_vertices, 1, 0, 0, 3, 1, 0, 0};
        mesh->edges.write(0, std::as_bytes(std::span(edges)));
        prepare(mesh->walls);
        mesh->walls.draw_indirect(mesh->edges, 0, gpu::Depth::nearest);
        prepare(mesh->below);
        mesh->below.draw_indirect(mesh->edges, 4 * sizeof(std::uint32_t), gpu::Depth::nearest);
    };
    const auto figures = [mesh] {
        MethodFigures result;
        if (mesh->cells.bytes() > 0) {
            const auto words = mesh->cells.read_all<std::uint32_t>();
            result.mesh_cells = static_cast<int>(words[1]);
            result.triangles = static_cast<long>(words[0] / 3) * result.mesh_cells;
        }
        result.bytes = mesh->cells.bytes() + mesh->indices.bytes();
        return result;
    };
    return {draw, figures};
}

}  // namespace talus::render
