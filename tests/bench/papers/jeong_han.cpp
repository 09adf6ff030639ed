// Jeong & Han 2006: what their envelope saves.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "render/methods/envelope.h"
#include "render/methods/simplified_block.h"
#include "tests/bench/papers/easel.h"
#include "tests/bench/papers/picture.h"
#include "tests/bench/papers/psnr.h"
#include "tests/bench/papers/table.h"
#include "tests/bench/papers/tables.h"

namespace talus::bench {
namespace {

constexpr int block_patches = render::glsl::envelope_patches;

// A ray in columns, rows and metres of height; a point of it is from + t * way.
struct Line {
    glm::dvec3 from;
    glm::dvec3 way;
    glm::dvec3 at(double t) const { return from + t * way; }
};

// The outer mesh of a block, and the box that just holds it.
class Block {
  public:
    Block(const PaperTerrain& terrain, glm::ivec2 number)
        : first_(number * block_patches),
          patches_(glm::min(first_ + block_patches, {terrain.grid.nx - 1, terrain.grid.ny - 1}) - first_) {
        std::vector<float> ground;
        for (int y = 0; y <= patches_.y; ++y)
            for (int x = 0; x <= patches_.x; ++x)
                ground.push_back(
                    terrain.heights[static_cast<std::size_t>(first_.y + y) * terrain.grid.nx + first_.x + x]);
        raised_ = render::raised_samples(ground, patches_);
        top_m_ = *std::max_element(raised_.begin(), raised_.end());
        bottom_m_ = *std::min_element(ground.begin(), ground.end());
    }

    // Where the line is over the block: from where to where.
    glm::dvec2 over(const Line& line) const {
        double begin = 0;
        double end = 1e30;
        for (int axis = 0; axis < 2; ++axis) {
            if (line.way[axis] == 0) continue;
            const double a = (first_[axis] - line.from[axis]) / line.way[axis];
            const double b = (first_[axis] + patches_[axis] - line.from[axis]) / line.way[axis];
            begin = std::max(begin, std::min(a, b));
            end = std::min(end, std::max(a, b));
        }
        return {begin, end};
    }
    // Where it is in the box as well.
    glm::dvec2 in_box(const Line& line) const {
        glm::dvec2 span = over(line);
        if (line.way.z != 0) {
            const double a = (top_m_ - line.from.z) / line.way.z;
            const double b = (bottom_m_ - line.from.z) / line.way.z;
            span = {std::max(span.x, std::min(a, b)), std::min(span.y, std::max(a, b))};
        }
        return span;
    }
    // Where it first comes under the outer mesh within a span; an infinity: nowhere. The mesh is plane
    // between columns, rows and diagonals.
    double under_envelope(const Line& line, glm::dvec2 span) const {
        std::vector<double> bends = {span.x, span.y};
        const std::array<glm::dvec2, 4> directions = {{{1, 0}, {0, 1}, {1, 1}, {1, -1}}};
        for (const glm::dvec2 direction : directions) {
            const double from = glm::dot(direction, glm::dvec2(line.from));
            const double way = glm::dot(direction, glm::dvec2(line.way));
            if (way == 0) continue;
            const double a = from + span.x * way;
            const double b = from + span.y * way;
            for (double k = std::ceil(std::min(a, b)); k <= std::max(a, b); ++k)
                bends.push_back((k - from) / way);
        }
        std::sort(bends.begin(), bends.end());
        double before_at = 0;
        double before = 0;
        for (std::size_t i = 0; i < bends.size(); ++i) {
            const glm::dvec3 point = line.at(bends[i]);
            const double above = point.z - height_m(glm::dvec2(point) - glm::dvec2(first_));
            if (above <= 0)
                return i == 0 ? bends[i] : before_at + (bends[i] - before_at) * before / (before - above);
            before_at = bends[i];
            before = above;
        }
        return HUGE_VAL;
    }

  private:
    double sample(int x, int y) const { return raised_[static_cast<std::size_t>(y) * (patches_.x + 1) + x]; }
    double height_m(glm::dvec2 place) const {
        const glm::ivec2 at = glm::clamp(glm::ivec2(glm::floor(place)), glm::ivec2(0), patches_ - 1);
        const glm::dvec2 in = glm::clamp(place - glm::dvec2(at), 0.0, 1.0);
        const double a = sample(at.x, at.y);
        const double b = sample(at.x + 1, at.y);
        const double c = sample(at.x, at.y + 1);
        const double d = sample(at.x + 1, at.y + 1);
        if (a + d >= b + c)
            return in.x >= in.y ? a + in.x * (b - a) + in.y * (d - b) : a + in.y * (c - a) + in.x * (d - c);
        return in.x + in.y <= 1 ? a + in.x * (b - a) + in.y * (c - a)
                                : d + (1 - in.x) * (c - d) + (1 - in.y) * (b - d);
    }

    glm::ivec2 first_;
    glm::ivec2 patches_;
    std::vector<float> raised_;
    double top_m_ = 0;
    double bottom_m_ = 0;
};

// Blocks and samples that a ray takes, from boxes and from envelopes.
struct Taken {
    double blocks_of_boxes = 0;
    double samples_of_boxes = 0;
    double blocks_of_envelopes = 0;
    double samples_of_envelopes = 0;
};

// Up to where the ray hits the ground; a column or a row lies between two samples.
void take(Taken& taken, const PaperTerrain& terrain, const Line& line, double hit) {
    const double spacing = 1 / std::max(std::abs(line.way.x), std::abs(line.way.y));
    const auto samples = [&](double begin, double end) { return 1 + std::ceil((end - begin) / spacing); };
    const glm::ivec2 blocks = (glm::ivec2(terrain.grid.nx, terrain.grid.ny) - 2) / block_patches;
    const glm::dvec2 step(line.way.x < 0 ? -1 : 1, line.way.y < 0 ? -1 : 1);
    double t = 0;
    // Where the ray comes over the terrain.
    for (int axis = 0; axis < 2; ++axis) {
        const double size = axis == 0 ? terrain.grid.nx - 1 : terrain.grid.ny - 1;
        const double near_plane = step[axis] > 0 ? 0 : size;
        if ((line.from[axis] - near_plane) * step[axis] < 0)
            t = std::max(t, (near_plane - line.from[axis]) / line.way[axis]);
    }
    glm::ivec2 number(glm::floor(glm::dvec2(line.at(t)) / double(block_patches)));
    number = glm::clamp(number, glm::ivec2(0), blocks);
    while (t <= hit && glm::clamp(number, glm::ivec2(0), blocks) == number) {
        const Block block(terrain, number);
        glm::dvec2 span = block.in_box(line);
        const double leave = block.over(line).y;
        span.y = std::min(span.y, hit);
        if (span.x <= span.y) {
            ++taken.blocks_of_boxes;
            taken.samples_of_boxes += samples(span.x, span.y);
            const double begin = block.under_envelope(line, span);
            if (begin <= span.y) {
                ++taken.blocks_of_envelopes;
                taken.samples_of_envelopes += samples(begin, span.y);
            }
        }
        // On over the side that comes first.
        const glm::dvec2 plane = glm::dvec2((number + glm::ivec2(step.x > 0, step.y > 0)) * block_patches);
        const glm::dvec2 side = (plane - glm::dvec2(line.from)) / glm::dvec2(line.way);
        if (side.x < side.y)
            number.x += static_cast<int>(step.x);
        else
            number.y += static_cast<int>(step.y);
        t = std::max(t, std::min(leave, std::min(side.x, side.y)));
    }
}

}  // namespace

// Samples that a ray takes up to its hit, from where it comes into a block's box, or under its outer mesh
// before simplification: worked out in double, of 1025² samples as theirs.
void jeong_han_samples(const PaperRun& run) {
    Table table("jeong_han_samples",
                "pictures,boxes_blocks,boxes_samples,envelopes_blocks,envelopes_samples,boxes_to_envelopes");
    const PaperTerrain terrain = paper_terrain_of(1025);
    constexpr glm::ivec2 size(160, 90);
    PaperEasel easel(terrain, size, run.patch_pixels);
    const Entry exact = entry("exact");
    for (const bool walks : {false, true}) {
        Taken taken;
        double count = 0;
        for (const render::Camera& camera : walks ? paper_walk(terrain, 5) : paper_flight(terrain, 5)) {
            const std::vector<float> distances = easel.distances(exact, camera);
            const render::CameraRays rays = camera_rays(camera, size.x, size.y);
            const glm::dvec3 from(terrain.grid.column_of(camera.eye.x), terrain.grid.row_of(camera.eye.y),
                                  camera.eye.z);
            for (int y = 0; y < size.y; ++y)
                for (int x = 0; x < size.x; ++x) {
                    const float hit = distances[static_cast<std::size_t>(y) * size.x + x];
                    if (std::isinf(hit)) continue;
                    const glm::dvec3 ray =
                        glm::normalize(rays.middle + (2 * (x + 0.5) / size.x - 1) * rays.right +
                                       (2 * (y + 0.5) / size.y - 1) * rays.up);
                    take(taken, terrain, {from, {ray.x / terrain.grid.dx, -ray.y / terrain.grid.dy, ray.z}},
                         hit);
                    ++count;
                }
        }
        table.row(fmt::format("{},{:.2f},{:.2f},{:.2f},{:.2f},{:.2f}", walks ? "walk" : "fly",
                              taken.blocks_of_boxes / count, taken.samples_of_boxes / count,
                              taken.blocks_of_envelopes / count, taken.samples_of_envelopes / count,
                              taken.samples_of_boxes / taken.samples_of_envelopes));
    }
}

// Jeong & Han 2006, figure 7 in kind: the mesh and the rays over 1025² samples, as pictures, and how
// far the distances of both are apart.
void jeong_han_pictures(const PaperRun& run) {
    Table table("jeong_han_pictures", "picture,psnr_to_mesh_db,differ_in_coverage,pixels");
    const PaperTerrain terrain = paper_terrain_of(1025);
    PaperEasel easel(terrain, small_picture, run.patch_pixels);
    const Terrain coloured(bedrock_terrain(terrain.grid, terrain.heights));
    render::Renderer renderer(coloured, run.patch_pixels);
    const render::Camera camera = paper_flight(terrain, 5)[1];
    const std::vector<float> by_mesh = easel.distances(entry("mesh"), camera);
    for (const char* method : {"mesh", "uniform"}) {
        render::ViewSettings settings;
        settings.method = method;
        write_picture(renderer, coloured, camera, settings, small_picture,
                      std::string("jeong_han_pictures ") + method);
        const std::vector<float> shown = easel.distances(entry(method), camera);
        Psnr psnr(terrain);
        psnr.add(shown, by_mesh);
        int differ = 0;
        for (std::size_t i = 0; i < shown.size(); ++i)
            differ += std::isinf(shown[i]) != std::isinf(by_mesh[i]) ? 1 : 0;
        table.row(fmt::format("{},{:.1f},{},{}", method, psnr.db(), differ, shown.size()));
    }
}

}  // namespace talus::bench
