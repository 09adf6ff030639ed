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
        : rays({"render/fullscreen.vert", "render/exact.frag"}, rays_defines(detail)) {}

    Beams beams{{"BEHIND_MESH", "FLAT_ENDS"}};
    gpu::Program reach{"render/hybrid_reach.comp"};
    gpu::Program list{"render/hybrid_cells.comp"};
    gpu::Program patches{std::vector<std::string>{"render/hybrid_patch.vert", "render/hybrid_patch.frag"}};
    gpu::Program patches_behind_rays{
        std::vector<std::string>{"render/hybrid_patch.vert", "render/hybrid_patch.frag"}, {"BEHIND_RAYS"}};
    gpu::Program rays;
    gpu::Buffer cells;
    gpu::Buffer sectors{"sectors", sector_count * sizeof(std::uint32_t)};
};

void draw(Hybrid& hybrid, const Frame& frame) {
    const Grid& grid = frame.terrain.grid();
    const int level = std::min(finest_cell_level, frame.pyramid.top_level());
    const glm::ivec2 size = frame.pyramid.level_1_size() >> (level - 1);
    const int cells = size.x * size.y;
    const std::size_t bytes = (16 + 2 * static_cast<std::size_t>(cells)) * sizeof(std::uint32_t);
    if (hybrid.cells.bytes() != bytes) hybrid.cells = gpu::Buffer("mesh cells", bytes);
    const unsigned vertices = 6U << (2U * static_cast<unsigned>(level));
    // Cells in front, cells behind rays, rays everywhere, rays behind the mesh.
    const std::array<std::uint32_t, 16> arguments = {vertices, 0, 0, 0, vertices, 0, 0, 0,
                                                     3,        1, 0, 0, 3,        0, 0, 0};
    hybrid.cells.write(0, std::as_bytes(std::span(arguments)));
    hybrid.sectors.fill(0x7f800000U);  // infinity
    const double pixel_m = 2 * std::tan(frame.camera.fov_deg * std::numbers::pi / 360) / frame.height;
    for (gpu::Program* program :
         {&hybrid.reach, &hybrid.list, &hybrid.patches, &hybrid.patches_behind_rays, &hybrid.rays}) {
        frame.pyramid.bind(*program, frame.terrain);
        set_camera(*program, grid, frame.camera, frame.width, frame.height);
        program->set("cell_level", level);
        program->set("pixel_m", static_cast<float>(pixel_m));
        program->set("pixels_per_patch",
                     frame.tolerance_px < mesh_error_px ? HUGE_VALF : static_cast<float>(frame.patch_pixels));
        program->set("near_m", static_cast<float>(1e-3 * std::min(grid.dx, grid.dy)));
    }
    frame.pyramid.lowest.bind_sampled(2);
    hybrid.cells.bind_storage(3);
    hybrid.sectors.bind_storage(4);
    hybrid.reach.dispatch((cells + 63) / 64);
    hybrid.list.dispatch((cells + 63) / 64);

    hybrid.beams.cast(frame, std::min(largest_flatness, frame.tolerance_px * pixel_m));
    const gpu::Region picture{0, 0, frame.width, frame.height};
    frame.hits.clear_depth(picture);
    frame.hits.bind(picture);
    hybrid.patches.set("first_cell", 0);
    hybrid.patches.draw_indirect(hybrid.cells, 0);
    hybrid.patches_behind_rays.set("first_cell", cells);
    hybrid.patches_behind_rays.draw_indirect(hybrid.cells, 4 * sizeof(std::uint32_t));
    hybrid.beams.bind();
    hybrid.beams.bind();
    if (std::getenv("OD")) {
        auto a = hybrid.cells.read_all<std::uint32_t>();
        std::printf("instances %u %u fragments %u\n", a[1], a[5], a[3]);
    }
    hybrid.rays.draw_fullscreen_indirect(hybrid.cells, 8 * sizeof(std::uint32_t));
    hybrid.rays.draw_fullscreen_behind_indirect(hybrid.cells, 12 * sizeof(std::uint32_t));
}

}  // namespace

Method make_hybrid(Detail detail) {
    auto hybrid = std::make_shared<Hybrid>(detail);
    return [hybrid](const Frame& frame) { draw(*hybrid, frame); };
}

}  // namespace talus
