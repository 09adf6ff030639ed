#include <bit>
#include <cmath>
#include <numbers>

#include "render/methods/beams.h"

namespace talus {
namespace {

// Cells of 32 x 32 patches, or the coarsest that the pyramid of a small terrain has.
constexpr int finest_cell_level = 5;
constexpr int sector_count = 1024;  // as in shaders/render/hybrid_sectors.glsl

// A patch's pixels are right to 1/64 pixel, and corners snap to 1/256: a finer tolerance asks for rays.
constexpr double mesh_error_px = 1.0 / 32;
// Two distances agree to 1e-4 (render/measure.h): what ends in flat cells stays within it.
constexpr double largest_flatness = 0.9e-4;

std::vector<std::string> rays_defines(Detail detail) {
    std::vector<std::string> defines = detail_defines(detail);
    defines.emplace_back("FLAT_ENDS");
    return defines;
}

struct Hybrid {
    explicit Hybrid(Detail detail)
        : rays({"render/fullscreen.vert", "render/exact.frag"}, rays_defines(detail)),
          ray_blocks({"render/block.vert", "render/exact.frag"}, rays_defines(detail)) {}

    Beams beams{{"BEHIND_MESH", "FLAT_ENDS"}};
    gpu::Program reach{"render/hybrid_reach.comp"};
    gpu::Program reach_changes{"render/hybrid_reach_changes.comp"};
    gpu::Program list{"render/hybrid_cells.comp"};
    gpu::Program patches{std::vector<std::string>{"render/hybrid_patch.vert", "render/hybrid_patch.frag"}};
    gpu::Program patches_behind_rays{
        std::vector<std::string>{"render/hybrid_patch.vert", "render/hybrid_patch.frag"}, {"BEHIND_RAYS"}};
    gpu::Program empty_blocks{std::vector<std::string>{"render/block.vert", "render/empty.frag"}};
    gpu::Program rays;
    gpu::Program ray_blocks;
    gpu::Buffer cells;
    gpu::Buffer sectors{"sectors", sector_count * sizeof(std::uint32_t)};
    gpu::Buffer sectors_before{"sectors before", sector_count * sizeof(std::uint32_t)};
};

// Which cells the mesh draws, and how far it reaches.
void choose_cells(Hybrid& hybrid, int cells, int cell_level, float mesh_end_m) {
    const unsigned vertices = 6U << (2U * static_cast<unsigned>(cell_level));
    // Cells in front, cells behind rays, rays everywhere, rays behind the mesh.
    const std::array<std::uint32_t, 16> arguments = {vertices, 0, 0, 0, vertices, 0, 0, 0,
                                                     3,        1, 0, 0, 3,        0, 0, 0};
    hybrid.cells.write(0, std::as_bytes(std::span(arguments)));
    hybrid.sectors.fill(std::bit_cast<std::uint32_t>(mesh_end_m));
    hybrid.cells.bind_storage(3);
    hybrid.sectors.bind_storage(4);
    hybrid.reach.dispatch((cells + 511) / 512);
    hybrid.list.dispatch((cells + 511) / 512);
}

void draw(Hybrid& hybrid, const Frame& frame) {
    const Grid& grid = frame.terrain.grid();
    const int level = std::min(finest_cell_level, frame.pyramid.top_level());
    const glm::ivec2 size = frame.pyramid.level_1_size() >> (level - 1);
    const int cells = size.x * size.y;
    const std::size_t bytes = (16 + 2 * static_cast<std::size_t>(cells)) * sizeof(std::uint32_t);
    if (hybrid.cells.bytes() != bytes) hybrid.cells = gpu::Buffer("mesh cells", bytes);
    const double pixel_m = 2 * std::tan(frame.camera.fov_deg * std::numbers::pi / 360) / frame.height;
    // A patch seen straight on covers the pixels that the mesh must have at this distance; on slopes up to
    // twice as many.
    const bool meshed = frame.tolerance_px >= mesh_error_px;
    const double patch_pixels = meshed ? frame.patch_pixels : HUGE_VAL;
    const auto mesh_end_m =
        static_cast<float>(std::sqrt(2 * grid.dx * grid.dy / std::max(patch_pixels, 1e-9)) / pixel_m);
    gpu::Program& rays = frame.redraw ? hybrid.ray_blocks : hybrid.rays;
    for (gpu::Program* program :
         {&hybrid.reach, &hybrid.list, &hybrid.patches, &hybrid.patches_behind_rays, &rays}) {
        frame.pyramid.bind(*program, frame.terrain);
        set_camera(*program, grid, frame.camera, frame.width, frame.height);
        program->set("cell_level", level);
        program->set("pixel_m", static_cast<float>(pixel_m));
        program->set("pixels_per_patch", static_cast<float>(patch_pixels));
        program->set("mesh_end_m", mesh_end_m);
        program->set("near_m", static_cast<float>(1e-3 * std::min(grid.dx, grid.dy)));
    }
    frame.pyramid.lowest.bind_sampled(2);
    if (frame.redraw) hybrid.sectors_before.copy_from(hybrid.sectors);
    choose_cells(hybrid, cells, level, mesh_end_m);
    hybrid.beams.cast(frame, std::min(largest_flatness, frame.tolerance_px * pixel_m));

    const gpu::Region picture{0, 0, frame.width, frame.height};
    if (frame.redraw) {
        hybrid.sectors_before.bind_storage(6);
        frame.redraw->bind(hybrid.reach_changes);
        hybrid.reach_changes.dispatch((sector_count + 63) / 64);
        hybrid.beams.mark_changes(frame);
        frame.redraw->list();
        set_camera(hybrid.empty_blocks, grid, frame.camera, frame.width, frame.height);
        frame.hits.bind(picture);
        frame.redraw->draw(hybrid.empty_blocks, gpu::Depth::reset);
    } else {
        frame.hits.clear_depth();
        frame.hits.bind(picture);
    }
    frame.terrain.ground.bind_sampled(0);
    frame.pyramid.highest.bind_sampled(1);
    hybrid.patches.set("first_cell", 0);
    hybrid.patches.draw_indirect(hybrid.cells, 0, gpu::Depth::nearest);
    hybrid.patches_behind_rays.set("first_cell", cells);
    hybrid.patches_behind_rays.draw_indirect(hybrid.cells, 4 * sizeof(std::uint32_t), gpu::Depth::nearest);
    hybrid.beams.bind();
    if (frame.redraw) {
        frame.redraw->draw(rays, gpu::Depth::behind);
    } else {
        rays.draw_indirect(hybrid.cells, 8 * sizeof(std::uint32_t), gpu::Depth::none);
        rays.draw_indirect(hybrid.cells, 12 * sizeof(std::uint32_t), gpu::Depth::behind);
    }
}

}  // namespace

Method make_hybrid(Detail detail) {
    auto hybrid = std::make_shared<Hybrid>(detail);
    const auto figures = [hybrid] {
        MethodFigures result;
        if (hybrid->cells.bytes() > 0) {
            const auto words = hybrid->cells.read_all<std::uint32_t>();
            result.mesh_cells = static_cast<int>(words[1] + words[5]);
            result.triangles = static_cast<long>(words[0] / 3) * result.mesh_cells;
        }
        result.bytes = hybrid->beams.bytes() + hybrid->cells.bytes() + 2 * hybrid->sectors.bytes();
        return result;
    };
    return {[hybrid](const Frame& frame) { draw(*hybrid, frame); }, figures};
}

}  // namespace talus
