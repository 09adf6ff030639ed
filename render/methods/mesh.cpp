#include "render/methods/cell_mesh.h"
#include "render/methods/cells_in_view.h"
#include "render/methods/method.h"
#include "render/methods/terrain_sides.h"

namespace talus::render {
namespace {

struct MeshMethod {
    CellsInView cells;
    CellMesh mesh;
    TerrainSides sides;
};

void draw(MeshMethod& method, const Frame& frame) {
    method.mesh.resize(1 << CellsInView::level(frame));
    method.cells.list(frame, method.mesh.indices_per_cell());
    begin_nearest(frame);
    method.mesh.draw(frame, method.cells.listed(), CellsInView::columns(frame));
    method.sides.draw(frame);
}

}  // namespace

std::vector<PixelKind> mesh_kinds(const OwnNumbers&) {
    return {{1, "mesh"}};
}

Method make_mesh(Detail) {
    auto mesh = std::make_shared<MeshMethod>();
    const auto figures = [mesh] {
        MethodFigures result = mesh->cells.figures();
        result.bytes += mesh->mesh.bytes();
        return result;
    };
    return {[mesh](const Frame& frame) { draw(*mesh, frame); }, figures};
}

}  // namespace talus::render
