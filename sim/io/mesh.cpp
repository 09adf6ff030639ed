// A terrain as triangles, few where it is smooth.
#include <fmt/format.h>
#include <meshoptimizer.h>

#include <algorithm>
#include <cmath>

#include "sim/error.h"
#include "sim/io/export.h"

namespace talus::io {
namespace {

// Height of a triangle over a place, and whether it lies over it.
std::optional<double> height_over(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c,
                                  glm::dvec2 p) {
    const double area = (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
    if (area == 0) return std::nullopt;
    const double u = ((b.x - p.x) * (c.y - p.y) - (c.x - p.x) * (b.y - p.y)) / area;
    const double v = ((c.x - p.x) * (a.y - p.y) - (a.x - p.x) * (c.y - p.y)) / area;
    const double w = 1 - u - v;
    constexpr double slack = -1e-9;
    if (u < slack || v < slack || w < slack) return std::nullopt;
    return u * a.z + v * b.z + w * c.z;
}

// How far samples lie above or below the triangles.
void measure(const Heightmap& heightmap, TerrainMesh& mesh) {
    const Grid& grid = heightmap.grid;
    mesh.farthest_m = 0;
    double sum = 0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const glm::dvec3 a = mesh.positions[mesh.indices[i]];
        const glm::dvec3 b = mesh.positions[mesh.indices[i + 1]];
        const glm::dvec3 c = mesh.positions[mesh.indices[i + 2]];
        const auto first = [](double v) { return static_cast<int>(std::ceil(v - 1e-6)); };
        const auto last = [](double v) { return static_cast<int>(std::floor(v + 1e-6)); };
        const int x0 = first(std::min({a.x, b.x, c.x}) / grid.dx);
        const int x1 = last(std::max({a.x, b.x, c.x}) / grid.dx);
        const int y0 = first(std::min({a.y, b.y, c.y}) / grid.dy);
        const int y1 = last(std::max({a.y, b.y, c.y}) / grid.dy);
        for (int y = y0; y <= y1; ++y)
            for (int x = x0; x <= x1; ++x) {
                const auto height = height_over(a, b, c, {x * grid.dx, y * grid.dy});
                if (!height) continue;
                const float sample =
                    heightmap.heights[static_cast<std::size_t>(grid.ny - 1 - y) * grid.nx + x];
                mesh.farthest_m = std::max(mesh.farthest_m, std::abs(*height - sample));
                sum += std::abs(*height - sample);
                ++count;
            }
    }
    mesh.mean_m = count > 0 ? sum / static_cast<double>(count) : 0;
}

}  // namespace

TerrainMesh simplified_mesh(const Heightmap& heightmap, double error_m) {
    if (!(error_m >= 0 && error_m <= 1e6))
        throw Error(fmt::format("a mesh cannot err by {} m, it must be 0 to 1000000", error_m));
    const Grid& grid = heightmap.grid;
    TerrainMesh full;
    full.positions.reserve(grid.count());
    for (int y = 0; y < grid.ny; ++y)
        for (int x = 0; x < grid.nx; ++x)
            full.positions.emplace_back(x * grid.dx, (grid.ny - 1 - y) * grid.dy,
                                        heightmap.heights[static_cast<std::size_t>(y) * grid.nx + x]);
    for (int y = 0; y + 1 < grid.ny; ++y)
        for (int x = 0; x + 1 < grid.nx; ++x) {
            const auto i = static_cast<unsigned>(y * grid.nx + x);
            const auto below = i + static_cast<unsigned>(grid.nx);
            // The shorter diagonal lies closer to the bilinear patch.
            const auto z = [&](unsigned k) { return full.positions[k].z; };
            if (std::abs(z(i) - z(below + 1)) < std::abs(z(i + 1) - z(below)))
                full.indices.insert(full.indices.end(), {i, below, below + 1, i, below + 1, i + 1});
            else
                full.indices.insert(full.indices.end(), {i, below, i + 1, i + 1, below, below + 1});
        }
    const float scale = meshopt_simplifyScale(&full.positions[0].x, full.positions.size(), sizeof(glm::vec3));
    TerrainMesh best = full;
    if (error_m > 0) {
        float reached = 0;
        best.indices.resize(meshopt_simplify(best.indices.data(), full.indices.data(), full.indices.size(),
                                             &full.positions[0].x, full.positions.size(), sizeof(glm::vec3),
                                             0, static_cast<float>(error_m / scale),
                                             meshopt_SimplifyLockBorder, &reached));
        best.error_m = static_cast<double>(reached) * scale;
        measure(heightmap, best);
    }
    meshopt_optimizeVertexCache(best.indices.data(), best.indices.data(), best.indices.size(),
                                best.positions.size());
    best.positions.resize(meshopt_optimizeVertexFetch(best.positions.data(), best.indices.data(),
                                                      best.indices.size(), best.positions.data(),
                                                      best.positions.size(), sizeof(glm::vec3)));
    return best;
}

TerrainMesh mesh_of_tile(const Heightmap& whole, double error_m, std::pair<int, int> columns,
                         std::pair<int, int> rows) {
    const Grid& grid = whole.grid;
    TerrainMesh mesh = simplified_mesh(piece_of(whole, columns, rows), error_m);
    mesh.normals.reserve(mesh.positions.size());
    mesh.texture_places.reserve(mesh.positions.size());
    for (glm::vec3& position : mesh.positions) {
        // A vertex is a sample.
        const int column = columns.first + static_cast<int>(std::lround(position.x / grid.dx));
        const int row = rows.first + rows.second - 1 - static_cast<int>(std::lround(position.y / grid.dy));
        mesh.normals.emplace_back(ground_normal(whole, column, row));
        mesh.texture_places.emplace_back((column + 0.5) / grid.nx, (row + 0.5) / grid.ny);
        // Of the whole, so that both sides of a seam have the same bits.
        position.x = static_cast<float>(column * grid.dx);
        position.y = static_cast<float>((grid.ny - 1 - row) * grid.dy);
    }
    return mesh;
}

}  // namespace talus::io
