#include <array>

#include "render/methods/cell_mesh.h"
#include "render/methods/cells_in_view.h"
#include "render/methods/envelope.h"
#include "render/methods/method.h"
#include "render/methods/simplified_envelope.h"
#include "render/methods/terrain_sides.h"

namespace talus::render {
namespace {

std::vector<std::string> with(Detail detail, const char* define) {
    std::vector<std::string> defines = detail_defines(detail);
    defines.emplace_back(define);
    return defines;
}

constexpr std::array<std::uint32_t, 4> one_triangle = {3, 1, 0, 0};

class Uniform {
  public:
    explicit Uniform(Detail detail)
        : raised_({"render/uniform.vert", "render/uniform.frag"}, detail_defines(detail)),
          simplified_faces_({"render/uniform.vert", "render/uniform.frag"}, with(detail, "SIMPLIFIED")),
          eye_({"render/uniform_eye.vert", "render/uniform.frag"}, with(detail, "EYE")),
          simplifies_(detail != Detail::steps) {}

    void draw(const Frame& frame) {
        envelope_.refresh(frame.terrain);
        simplified_.follow(frame.terrain, envelope_, simplifies_);
        list(frame);
        begin_nearest(frame);
        for (int kind = 0; kind < glsl::block_kinds; ++kind)
            draw_blocks(kind == glsl::block_kinds - 1 ? raised_ : simplified_faces_, kind, frame);
        prepare(eye_, frame);
        eye_.draw_indirect(eye_arguments_, 0, gpu::Depth::nearest);
        sides_.draw(frame);
    }

    // Waits until every block was simplified, as far as it can be.
    void finish(const Terrain& terrain) {
        envelope_.refresh(terrain);
        simplified_.finish(terrain, envelope_, simplifies_);
    }

    MethodFigures figures() const {
        MethodFigures result = cells_.figures();
        result.mesh_cells = 0;
        result.triangles = 0;
        if (blocks_.bytes() != 0) {
            const auto words = blocks_.read_all<std::uint32_t>();
            for (int kind = 0; kind < glsl::block_kinds; ++kind)
                result.triangles += words[static_cast<std::size_t>(4) * kind] / 3;
        }
        result.bytes += envelope_.bytes() + simplified_.bytes() + blocks_.bytes();
        return result;
    }

  private:
    static glm::ivec2 blocks_of(const Terrain& terrain) {
        const Grid& grid = terrain.grid();
        return (glm::ivec2(grid.nx, grid.ny) - 2) / glsl::envelope_patches + 1;
    }

    void list(const Frame& frame) {
        const int level = CellsInView::level(frame);
        cells_.list(frame, 0);
        const glm::ivec2 blocks = blocks_of(frame.terrain);
        std::vector<std::uint32_t> arguments(static_cast<std::size_t>(4) * glsl::block_kinds, 0);
        for (std::size_t kind = 0; kind < glsl::block_kinds; ++kind) arguments[4 * kind + 1] = 1;
        const std::size_t words =
            arguments.size() + static_cast<std::size_t>(glsl::block_kinds) * blocks.x * blocks.y;
        if (blocks_.bytes() != words * sizeof(std::uint32_t))
            blocks_ = gpu::Buffer("blocks of uniform", words * sizeof(std::uint32_t));
        blocks_.write(0, std::as_bytes(std::span(arguments)));
        frame.pyramid.bind(list_, frame.terrain);
        list_.bind_storage("MeshCells", cells_.listed());
        list_.bind_storage("EnvelopeVersions", envelope_.versions());
        list_.bind_storage("SimplifiedVersions", simplified_.versions());
        list_.bind_storage("SimplifiedBlocks", simplified_.triangles());
        list_.bind_storage("UniformBlocks", blocks_);
        list_.set("cell_level", level);
        list_.set("blocks", blocks);
        list_.set("tile_columns", frame.terrain.tiles.columns());
        const glm::ivec2 cells = frame.pyramid.level_1_size() >> (level - 1);
        const int blocks_of_cell = 1 << (2 * std::max(level - glsl::envelope_level, 0));
        list_.dispatch((std::max(cells.x * cells.y * blocks_of_cell, blocks.x * blocks.y) + 63) / 64);
        gpu::barrier({gpu::Use::storage, gpu::Use::indirect, gpu::Use::buffer_transfer});
    }

    void draw_blocks(gpu::Program& program, int kind, const Frame& frame) {
        prepare(program, frame);
        program.bind_storage("UniformBlocks", blocks_);
        program.bind_storage("SimplifiedBlocks", simplified_.triangles());
        program.bind_sampled("envelope", envelope_.heights());
        program.set("kind", kind);
        program.set("blocks", blocks_of(frame.terrain));
        program.set("tile_columns", frame.terrain.tiles.columns());
        program.draw_indirect(blocks_, static_cast<std::size_t>(4) * kind * sizeof(std::uint32_t),
                              gpu::Depth::nearest);
    }

    static void prepare(gpu::Program& program, const Frame& frame) {
        frame.pyramid.bind(program, frame.terrain);
        set_camera(program, frame.terrain.grid(), frame.camera, frame.width, frame.height);
        program.set("near_m", near_plane_m(frame.terrain.grid()));
    }

    gpu::Program raised_;
    gpu::Program simplified_faces_;
    gpu::Program eye_;
    gpu::Program list_{"render/uniform_blocks.comp"};
    gpu::Buffer eye_arguments_{"arguments of the eye's block", std::as_bytes(std::span(one_triangle))};
    // Steps are counted from the envelope on: those of a picture must not hang on how far a thread is.
    bool simplifies_;
    Envelope envelope_;
    SimplifiedEnvelope simplified_;
    CellsInView cells_;
    gpu::Buffer blocks_;
    TerrainSides sides_;
};

}  // namespace

std::vector<PixelKind> uniform_kinds(const OwnNumbers&) {
    return {{1, "the terrain's sides"}, {2, "sampled rays"}};
}

Method make_uniform(Detail detail) {
    auto uniform = std::make_shared<Uniform>(detail);
    return {[uniform](const Frame& frame) { uniform->draw(frame); }, [uniform] { return uniform->figures(); },
            [uniform](const Terrain& terrain) { uniform->finish(terrain); }};
}

}  // namespace talus::render
