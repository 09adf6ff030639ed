#include <array>

#include "render/methods/cell_mesh.h"
#include "render/methods/cells_in_view.h"
#include "render/methods/envelope.h"
#include "render/methods/method.h"
#include "render/methods/terrain_sides.h"

namespace talus::render {
namespace {

std::vector<std::string> eye_defines(Detail detail) {
    std::vector<std::string> defines = detail_defines(detail);
    defines.emplace_back("EYE");
    return defines;
}

constexpr std::array<std::uint32_t, 4> one_triangle = {3, 1, 0, 0};

class Uniform {
  public:
    explicit Uniform(Detail detail)
        : faces_({"render/uniform.vert", "render/uniform.frag"}, detail_defines(detail)),
          eye_({"render/uniform_eye.vert", "render/uniform.frag"}, eye_defines(detail)) {}

    void draw(const Frame& frame) {
        envelope_.refresh(frame.terrain);
        const int level = CellsInView::level(frame);
        cells_.list(frame, 6 << (2 * level));
        begin_nearest(frame);
        prepare(faces_, frame);
        faces_.bind_storage("MeshCells", cells_.listed());
        faces_.bind_sampled("envelope", envelope_.heights());
        faces_.set("cell_level", level);
        faces_.draw_indirect(cells_.listed(), 0, gpu::Depth::nearest);
        prepare(eye_, frame);
        eye_.draw_indirect(eye_arguments_, 0, gpu::Depth::nearest);
        sides_.draw(frame);
    }

    MethodFigures figures() const {
        MethodFigures result = cells_.figures();
        result.mesh_cells = 0;
        result.bytes += envelope_.bytes();
        return result;
    }

  private:
    static void prepare(gpu::Program& program, const Frame& frame) {
        frame.pyramid.bind(program, frame.terrain);
        set_camera(program, frame.terrain.grid(), frame.camera, frame.width, frame.height);
        program.set("near_m", near_plane_m(frame.terrain.grid()));
    }

    gpu::Program faces_;
    gpu::Program eye_;
    gpu::Buffer eye_arguments_{"arguments of the eye's block", std::as_bytes(std::span(one_triangle))};
    Envelope envelope_;
    CellsInView cells_;
    TerrainSides sides_;
};

}  // namespace

std::vector<PixelKind> uniform_kinds(const OwnNumbers&) {
    return {{1, "the terrain's sides"}, {2, "sampled rays"}};
}

Method make_uniform(Detail detail) {
    auto uniform = std::make_shared<Uniform>(detail);
    return {[uniform](const Frame& frame) { uniform->draw(frame); },
            [uniform] { return uniform->figures(); }};
}

}  // namespace talus::render
