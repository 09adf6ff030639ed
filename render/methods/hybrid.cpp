#include <algorithm>
#include <array>
#include <cmath>

#include "render/methods/ray_casting.h"

namespace talus::render {
namespace {

// Cells of 16 x 16 patches, or the coarsest that the pyramid of a small terrain has.
constexpr int sector_cell_level = 4;
#include "render/sector_count.glsl"

// A patch's pixels are right to 1/64 pixel, and corners snap to 1/256: a finer tolerance asks for rays.
constexpr double mesh_error_px = 1.0 / 32;
// Two distances agree to 1e-4 (render/measure.h): what ends in flat cells stays within it.
constexpr double largest_flatness = 0.9e-4;
// Drawing any mesh at all costs as much as rays for this share of the picture (docs/benchmarks.md).
constexpr double least_gain = 1.0 / 16;
// So many that one group chooses them in well under a millisecond.
constexpr int most_cells = 4096;

struct Hybrid {
    explicit Hybrid(Detail detail)
        : rays({detail_defines(detail), true, [this](gpu::Program& program) { bind_lists(program); }}) {}
    Hybrid(const Hybrid&) = delete;
    Hybrid& operator=(const Hybrid&) = delete;

    void bind_lists(gpu::Program& program) const {
        program.bind_storage("MeshCells", cells);
        program.bind_storage("Reach", sectors);
    }

    RayCasting rays;
    gpu::Program reach_changes{"render/hybrid_reach_changes.comp"};
    gpu::Program choose{"render/hybrid_cells.comp"};
    gpu::Program patches{std::vector<std::string>{"render/hybrid_patch.vert", "render/hybrid_patch.frag"}};
    gpu::Program patches_behind_rays{
        std::vector<std::string>{"render/hybrid_patch.vert", "render/hybrid_patch.frag"}, {"BEHIND_RAYS"}};
    gpu::Program reset_blocks{std::vector<std::string>{"render/block.vert", "render/no_colour.frag"}};
    gpu::Buffer cells;
    gpu::Buffer sectors{"sectors", sector_count * sizeof(std::uint32_t)};
    gpu::Buffer sectors_before{"sectors before", sector_count * sizeof(std::uint32_t)};
};

// The cells that the picture may show and the mesh may reach, first and count in columns and rows: none where
// the eye looks past the terrain.
struct CellRectangle {
    glm::ivec2 first;
    glm::ivec2 count;
};

// A rectangle over ground, from the eye, around all that lies within a distance and in the picture.
struct GroundRectangle {
    glm::dvec2 low{0};
    glm::dvec2 high{0};
    void take(glm::dvec2 place) {
        low = glm::min(low, place);
        high = glm::max(high, place);
    }
};
GroundRectangle ground_in_view(const CameraRays& rays, double distance_m) {
    const std::array<glm::dvec2, 4> axes = {
        {{distance_m, 0}, {-distance_m, 0}, {0, distance_m}, {0, -distance_m}}};
    GroundRectangle ground;
    // The ways of the picture's corners over ground, a twentieth of its size beyond them.
    std::array<glm::dvec2, 4> ways{};
    const glm::dvec2 ahead(rays.middle);
    bool all_ahead = true;
    for (int i = 0; i < 4; ++i) {
        ways[i] = glm::dvec2(rays.middle + 1.1 * ((i & 1) == 0 ? -1 : 1) * rays.right +
                             1.1 * ((i & 2) == 0 ? -1 : 1) * rays.up);
        all_ahead = all_ahead && glm::dot(ways[i], ahead) > 0.01 * glm::length(ways[i]) * glm::length(ahead);
    }
    if (!all_ahead) {
        for (const glm::dvec2 axis : axes) ground.take(axis);
        return ground;
    }
    // A sector of the circle: its two edges, and the axes between them.
    const auto side = [&](glm::dvec2 way) { return ahead.x * way.y - ahead.y * way.x; };
    const auto slope = [&](glm::dvec2 way) { return side(way) / glm::dot(ahead, way); };
    const auto [right, left] =
        std::minmax_element(ways.begin(), ways.end(), [&](auto a, auto b) { return slope(a) < slope(b); });
    ground.take(distance_m * glm::normalize(*right));
    ground.take(distance_m * glm::normalize(*left));
    for (const glm::dvec2 axis : axes)
        if (glm::dot(ahead, axis) > 0 && slope(axis) > slope(*right) && slope(axis) < slope(*left))
            ground.take(axis);
    return ground;
}

CellRectangle cells_within(const Frame& frame, int level, double distance_m) {
    const Grid& grid = frame.terrain.grid();
    const glm::dvec2 eye(grid.column_of(frame.camera.eye.x), grid.row_of(frame.camera.eye.y));
    const GroundRectangle ground =
        ground_in_view(camera_rays(frame.camera, frame.width, frame.height), distance_m);
    const glm::dvec2 patches(grid.nx - 1, grid.ny - 1);
    // Rows grow to the south.
    const glm::dvec2 low = glm::clamp(eye + glm::dvec2(ground.low.x / grid.dx, -ground.high.y / grid.dy),
                                      glm::dvec2(0), patches);
    const glm::dvec2 high = glm::clamp(eye + glm::dvec2(ground.high.x / grid.dx, -ground.low.y / grid.dy),
                                       glm::dvec2(0), patches);
    if (low.x >= high.x || low.y >= high.y) return {glm::ivec2(0), glm::ivec2(0)};
    const glm::ivec2 first = glm::ivec2(low) >> level;
    return {first, (glm::ivec2(glm::ceil(high)) >> level) - first + 1};
}

void make_room(Hybrid& hybrid, const CellRectangle& cells) {
    const std::size_t bytes =
        (8 + 2 * static_cast<std::size_t>(cells.count.x) * cells.count.y) * sizeof(std::uint32_t);
    if (hybrid.cells.bytes() < bytes) hybrid.cells = gpu::Buffer("mesh cells", bytes);
}

void draw(Hybrid& hybrid, const Frame& frame) {
    const Grid& grid = frame.terrain.grid();
    const double pixel_m = pixel_width_m(frame.camera, frame.height, 1);
    // The mesh ends at the distance where a patch seen straight on covers half of patch_pixels: on slopes it
    // covers up to twice as many.
    const bool meshed = frame.tolerance_px >= mesh_error_px;
    const double patch_pixels = meshed ? frame.patch_pixels : HUGE_VAL;
    const double mesh_end_m = std::sqrt(2 * grid.dx * grid.dy / std::max(patch_pixels, 1e-9)) / pixel_m;
    // Coarser cells where the mesh reaches far, so that choosing them stays cheap.
    int level = std::min(sector_cell_level, frame.pyramid.top_level());
    CellRectangle cells = cells_within(frame, level, mesh_end_m);
    while (level < frame.pyramid.top_level() && cells.count.x * cells.count.y > most_cells)
        cells = cells_within(frame, ++level, mesh_end_m);
    const auto prepare = [&](gpu::Program& program) {
        frame.pyramid.bind(program, frame.terrain);
        hybrid.bind_lists(program);
        set_camera(program, grid, frame.camera, frame.width, frame.height);
        program.set("cell_level", level);
        program.set("pixel_m", static_cast<float>(pixel_m));
        program.set("pixels_per_patch", static_cast<float>(patch_pixels));
        program.set("mesh_end_m", static_cast<float>(mesh_end_m));
        program.set("near_m", static_cast<float>(1e-3 * std::min(grid.dx, grid.dy)));
    };
    if (frame.redraw) hybrid.sectors_before.copy_from(hybrid.sectors);
    make_room(hybrid, cells);
    // Which cells the mesh draws, and how far it reaches.
    prepare(hybrid.choose);
    hybrid.choose.set("least_gain", static_cast<float>(least_gain));
    hybrid.choose.set("first_cell", cells.first);
    hybrid.choose.set("cell_count", cells.count);
    hybrid.choose.dispatch(1);
    gpu::barrier({gpu::Use::storage, gpu::Use::indirect, gpu::Use::buffer_transfer});
    const RayPicture rays = ray_picture(frame);
    hybrid.rays.cast_beams(rays, std::min(largest_flatness, frame.tolerance_px * pixel_m));

    const gpu::Region picture{0, 0, frame.width, frame.height};
    if (frame.redraw) {
        hybrid.bind_lists(hybrid.reach_changes);
        hybrid.reach_changes.bind_storage("ReachBefore", hybrid.sectors_before);
        frame.redraw->bind(hybrid.reach_changes);
        hybrid.reach_changes.dispatch((sector_count + 63) / 64);
        gpu::barrier({gpu::Use::storage});
        hybrid.rays.beams().mark_changes(rays);
        frame.redraw->list();
        frame.redraw->draw(hybrid.reset_blocks, frame.hits, gpu::Depth::reset);
    } else if (cells.count.x > 0) {
        frame.hits.clear_depth();
    }
    frame.hits.bind(picture);
    prepare(hybrid.patches);
    hybrid.patches.set("second_half", 0);
    hybrid.patches.draw_indirect(hybrid.cells, 0, gpu::Depth::nearest);
    prepare(hybrid.patches_behind_rays);
    hybrid.patches_behind_rays.set("second_half", 1);
    hybrid.patches_behind_rays.draw_indirect(hybrid.cells, 4 * sizeof(std::uint32_t), gpu::Depth::nearest);
    hybrid.rays.draw(rays);
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
        result.bytes = hybrid->rays.bytes() + hybrid->cells.bytes() + 2 * hybrid->sectors.bytes();
        return result;
    };
    return {[hybrid](const Frame& frame) { draw(*hybrid, frame); }, figures};
}

}  // namespace talus::render
