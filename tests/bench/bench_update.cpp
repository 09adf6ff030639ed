// What a small change costs: refreshing the pyramid after one dab, on terrains of growing size; against a
// full refresh, and against Embree's two levels of triangles.
#include <embree3/rtcore.h>
#include <fmt/format.h>

#include <memory>

#include "render/pyramid.h"
#include "sim/passes/brush.h"
#include "sim/terrain/generate.h"
#include "tests/bench/measure.h"

namespace talus::bench {

namespace {

// Tiles of 64 x 64 patches as triangle scenes of low build quality, instances of one scene.
class EmbreeTiles {
  public:
    EmbreeTiles(const Grid& grid, const std::vector<float>& heights)
        : device_(rtcNewDevice("threads=2")), top_(rtcNewScene(device_)) {
        for (int y = 0; y + 64 < grid.ny; y += 64)
            for (int x = 0; x + 64 < grid.nx; x += 64) {
                tiles_.push_back(build(grid, heights, x, y));
                RTCGeometry instance = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_INSTANCE);
                rtcSetGeometryInstancedScene(instance, tiles_.back());
                rtcCommitGeometry(instance);
                instances_.push_back(instance);
                rtcAttachGeometry(top_, instance);
            }
        rtcSetSceneBuildQuality(top_, RTC_BUILD_QUALITY_LOW);
        rtcCommitScene(top_);
    }
    ~EmbreeTiles() {
        for (RTCGeometry instance : instances_) rtcReleaseGeometry(instance);
        for (RTCScene tile : tiles_) rtcReleaseScene(tile);
        rtcReleaseScene(top_);
        rtcReleaseDevice(device_);
    }
    EmbreeTiles(const EmbreeTiles&) = delete;
    EmbreeTiles& operator=(const EmbreeTiles&) = delete;

    void rebuild_one(const Grid& grid, const std::vector<float>& heights) {
        const std::size_t at = tiles_.size() / 2;
        const int columns = (grid.nx - 1) / 64;
        rtcReleaseScene(tiles_[at]);
        tiles_[at] =
            build(grid, heights, static_cast<int>(at) % columns * 64, static_cast<int>(at) / columns * 64);
        rtcSetGeometryInstancedScene(instances_[at], tiles_[at]);
        rtcCommitGeometry(instances_[at]);
        rtcCommitScene(top_);
    }

  private:
    RTCScene build(const Grid& grid, const std::vector<float>& heights, int x0, int y0) {
        constexpr unsigned side = 65;
        RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
        rtcSetGeometryBuildQuality(geometry, RTC_BUILD_QUALITY_LOW);
        auto* vertices = static_cast<float*>(rtcSetNewGeometryBuffer(
            geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), side * side));
        auto* indices = static_cast<unsigned*>(rtcSetNewGeometryBuffer(
            geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(unsigned), 2 * 64 * 64));
        for (unsigned y = 0; y < side; ++y)
            for (unsigned x = 0; x < side; ++x) {
                float* v = vertices + 3 * static_cast<std::size_t>(y * side + x);
                const int column = x0 + static_cast<int>(x);
                const int row = y0 + static_cast<int>(y);
                v[0] = static_cast<float>(column * grid.dx);
                v[1] = static_cast<float>((grid.ny - 1 - row) * grid.dy);
                v[2] = heights[static_cast<std::size_t>(row) * grid.nx + column];
            }
        for (unsigned y = 0; y < 64; ++y)
            for (unsigned x = 0; x < 64; ++x) {
                const unsigned a = y * side + x;
                for (const unsigned i : {a, a + side, a + 1, a + 1, a + side, a + side + 1}) *indices++ = i;
            }
        rtcCommitGeometry(geometry);
        RTCScene scene = rtcNewScene(device_);
        rtcSetSceneBuildQuality(scene, RTC_BUILD_QUALITY_LOW);
        rtcAttachGeometry(scene, geometry);
        rtcReleaseGeometry(geometry);
        rtcCommitScene(scene);
        return scene;
    }

    RTCDevice device_;
    RTCScene top_;
    std::vector<RTCScene> tiles_;
    std::vector<RTCGeometry> instances_;
};

}  // namespace

void bench_update() {
    struct Case {
        explicit Case(const Grid& grid)
            : terrain(bedrock_terrain(grid, generate_heights(grid, {"hills", 2, 500}))),
              pyramid(terrain),
              brush(terrain) {
            pyramid.refresh(terrain);
        }
        Terrain terrain;
        render::Pyramid pyramid;
        Brush brush;
    };
    std::vector<std::unique_ptr<Case>> cases;
    std::vector<Contestant> contestants;
    const std::vector<int> sizes = {512, 1024, 2048, 4096};
    for (const int size : sizes) {
        cases.push_back(std::make_unique<Case>(Grid{size, size, 10, 10}));
        Case& here = *cases.back();
        const auto dab = [&here] {
            const Grid& grid = here.terrain.grid();
            here.brush.dab(here.terrain, {RaiseDab{}, grid.width_m() / 2, grid.height_m() / 2, 320, 1, 1, 0,
                                          0, Material::bedrock});
        };
        contestants.push_back({fmt::format("{}² dab", size), [dab] {
                                   for (int i = 0; i < 50; ++i) dab();
                               }});
        contestants.push_back({fmt::format("{}² dab and refresh", size), [dab, &here] {
                                   for (int i = 0; i < 50; ++i) {
                                       dab();
                                       here.pyramid.refresh(here.terrain);
                                   }
                               }});
    }
    const std::vector<double> seconds = interleave(contestants, 9);
    fmt::print(
        "a dab of 64 x 64 samples, then the pyramid's refresh; time of one\n{:<8} {:>10} {:>12} {:>10}\n",
        "samples", "dab ms", "refresh ms", "to 512²");
    for (std::size_t i = 0; i < sizes.size(); ++i) {
        const double dab_ms = seconds[2 * i] * 20;
        const double refresh_ms = (seconds[2 * i + 1] - seconds[2 * i]) * 20;
        fmt::print("{:<8} {:>10.3f} {:>12.3f} {:>10.2f}\n", sizes[i], dab_ms, refresh_ms,
                   refresh_ms / ((seconds[1] - seconds[0]) * 20));
    }

    // One tile of 2049², against all of it and against Embree.
    const Grid grid{2049, 2049, 10, 10};
    const std::vector<float> heights = generate_heights(grid, {"hills", 2, 500});
    Terrain terrain(bedrock_terrain(grid, heights));
    render::Pyramid pyramid(terrain);
    pyramid.refresh(terrain);
    EmbreeTiles embree(grid, heights);
    const gpu::Region tile{1024, 1024, 64, 64};
    const std::vector<double> s = interleave({{"mark a tile",
                                               [&] {
                                                   for (int i = 0; i < 20; ++i) terrain.refresh(tile);
                                               }},
                                              {"mark and refresh a tile",
                                               [&] {
                                                   for (int i = 0; i < 20; ++i) {
                                                       terrain.refresh(tile);
                                                       pyramid.refresh(terrain);
                                                   }
                                               }},
                                              {"refresh everything",
                                               [&] {
                                                   terrain.tiles.mark_all();
                                                   pyramid.refresh(terrain);
                                               }},
                                              {"Embree, one tile",
                                               [&] {
                                                   for (int i = 0; i < 20; ++i)
                                                       embree.rebuild_one(grid, heights);
                                               }}},
                                             9);
    const double one = (s[1] - s[0]) / 20;
    fmt::print(
        "2049²: one tile {:.3f} ms, everything {:.1f} ms ({:.0f} times), Embree's tile {:.3f} ms ({:.1f} "
        "times)\n",
        1e3 * one, 1e3 * s[2], s[2] / one, 1e3 * s[3] / 20, s[3] / 20 / one);
}

}  // namespace talus::bench
