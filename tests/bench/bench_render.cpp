// The exact caster against Embree's grid geometry, same rays, same threads.
#include <embree3/rtcore.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <thread>

#include "render/hits_target.h"
#include "render/methods/method.h"
#include "render/shading.h"
#include "sim/terrain/generate.h"
#include "tests/bench/measure.h"

namespace talus::bench {
namespace {

class EmbreeGrid {
  public:
    EmbreeGrid(const Grid& grid, const std::vector<float>& heights)
        : device_(rtcNewDevice("threads=2")), scene_(rtcNewScene(device_)) {
        RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_GRID);
        auto* vertices = static_cast<float*>(rtcSetNewGeometryBuffer(
            geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), grid.count()));
        for (int row = 0; row < grid.ny; ++row)
            for (int column = 0; column < grid.nx; ++column) {
                const std::size_t i = static_cast<std::size_t>(row) * grid.nx + column;
                vertices[3 * i] = static_cast<float>(column * grid.dx);
                vertices[3 * i + 1] = static_cast<float>((grid.ny - 1 - row) * grid.dy);
                vertices[3 * i + 2] = heights[i];
            }
        auto* grids = static_cast<RTCGrid*>(
            rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_GRID, 0, RTC_FORMAT_GRID, sizeof(RTCGrid), 1));
        grids[0] = {0, static_cast<unsigned>(grid.nx), static_cast<unsigned short>(grid.nx),
                    static_cast<unsigned short>(grid.ny)};
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(scene_, geometry);
        rtcReleaseGeometry(geometry);
        rtcCommitScene(scene_);
    }
    ~EmbreeGrid() {
        rtcReleaseScene(scene_);
        rtcReleaseDevice(device_);
    }
    EmbreeGrid(const EmbreeGrid&) = delete;
    EmbreeGrid& operator=(const EmbreeGrid&) = delete;

    int cast(const render::Camera& camera) const {
        const render::CameraRays rays = camera_rays(camera, width, height);
        return for_packets([&](int x, int y) { return packet(camera, rays, x, y); });
    }

    /// From where the pixels' rays hit, row 0 at the bottom, towards the sun: how many hit something.
    int cast_shadows(const render::Camera& camera, const std::vector<float>& distances,
                     glm::dvec3 sun) const {
        const render::CameraRays rays = camera_rays(camera, width, height);
        return for_packets([&](int x, int y) { return shadow_packet(camera, rays, distances, sun, x, y); });
    }

  private:
    template <typename Packet>
    static int for_packets(const Packet& packet) {
        std::array<int, 2> hits{};
        std::array<std::thread, 2> threads;
        for (int t = 0; t < 2; ++t)
            threads[t] = std::thread([&, t] {
                for (int y = t; y < height / 2; y += 2)
                    for (int x = 0; x < width; x += 4) hits[t] += packet(x, 2 * y);
            });
        for (std::thread& thread : threads) thread.join();
        return hits[0] + hits[1];
    }

    static glm::vec3 pixel_way(const render::CameraRays& rays, int x, int y) {
        const float sx = 2.0F * (static_cast<float>(x) + 0.5F) / width - 1;
        const float sy = 2.0F * (static_cast<float>(y) + 0.5F) / height - 1;
        return glm::normalize(glm::vec3(rays.forward) + sx * glm::vec3(rays.right) + sy * glm::vec3(rays.up));
    }

    int shadow_packet(const render::Camera& camera, const render::CameraRays& rays,
                      const std::vector<float>& distances, glm::dvec3 sun, int x0, int y0) const {
        alignas(32) std::array<int, 8> valid{};
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
        RTCRay8 r;
        for (int i = 0; i < 8; ++i) {
            const int x = x0 + i % 4;
            const int y = y0 + i / 4;
            const float distance = distances[static_cast<std::size_t>(y) * width + x];
            valid[i] = std::isfinite(distance) ? -1 : 0;
            const glm::vec3 at =
                glm::vec3(camera.eye) + (std::isfinite(distance) ? distance : 0) * pixel_way(rays, x, y);
            r.org_x[i] = at.x;
            r.org_y[i] = at.y;
            r.org_z[i] = at.z;
            r.dir_x[i] = static_cast<float>(sun.x);
            r.dir_y[i] = static_cast<float>(sun.y);
            r.dir_z[i] = static_cast<float>(sun.z);
            r.tnear[i] = 0.5F;
            r.tfar[i] = HUGE_VALF;
            r.mask[i] = ~0U;
            r.flags[i] = 0;
            r.time[i] = 0;
            r.id[i] = 0;
        }
        rtcOccluded8(valid.data(), scene_, &context, &r);
        int hits = 0;
        for (int i = 0; i < 8; ++i) hits += valid[i] != 0 && r.tfar[i] < 0 ? 1 : 0;
        return hits;
    }

    // 4 x 2 pixels.
    int packet(const render::Camera& camera, const render::CameraRays& rays, int x0, int y0) const {
        alignas(32) const std::array<int, 8> valid = {-1, -1, -1, -1, -1, -1, -1, -1};
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
        RTCRayHit8 r;
        for (int i = 0; i < 8; ++i) {
            const glm::vec3 d = pixel_way(rays, x0 + i % 4, y0 + i / 4);
            r.ray.org_x[i] = static_cast<float>(camera.eye.x);
            r.ray.org_y[i] = static_cast<float>(camera.eye.y);
            r.ray.org_z[i] = static_cast<float>(camera.eye.z);
            r.ray.dir_x[i] = d.x;
            r.ray.dir_y[i] = d.y;
            r.ray.dir_z[i] = d.z;
            r.ray.tnear[i] = 0;
            r.ray.tfar[i] = HUGE_VALF;
            r.ray.mask[i] = ~0U;
            r.ray.flags[i] = 0;
            r.ray.time[i] = 0;
            r.ray.id[i] = 0;
            r.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
            r.hit.instID[0][i] = RTC_INVALID_GEOMETRY_ID;
        }
        rtcIntersect8(valid.data(), scene_, &context, &r);
        int hits = 0;
        for (int i = 0; i < 8; ++i) hits += r.hit.geomID[i] != RTC_INVALID_GEOMETRY_ID ? 1 : 0;
        return hits;
    }

    RTCDevice device_;
    RTCScene scene_;
};

}  // namespace

void bench_render() {
    const Grid grid{2049, 2049, 10, 10};
    const std::vector<float> heights = generate_heights(grid, {"mountains", 4, 2500});
    Terrain terrain(bedrock_terrain(grid, heights));
    render::Pyramid pyramid(terrain);
    pyramid.refresh(terrain);
    const EmbreeGrid embree(grid, heights);
    const render::HitsTarget target(width, height);
    const render::Method exact = render::make_exact(render::Detail::none);
    const render::Method counting = make_exact(render::Detail::steps);
    const render::SkyView sky(terrain);
    render::Shading shading;
    const gpu::Texture colour("colour", gpu::Format::rgba8, width, height);
    const std::array<const gpu::Texture*, 1> colours = {&colour};
    const gpu::Framebuffer colour_buffer("colour", colours);

    const double extent = grid.width_m();
    const double middle = heights[grid.count() / 2];
    const std::vector<std::pair<std::string, render::Camera>> views = {
        {"grazing",
         {{0.5 * extent, 0.5 * extent, middle + 60}, {0.9 * extent, 0.95 * extent, middle + 40}, 60}},
        {"fly", {{0.15 * extent, 0.1 * extent, 3600}, {0.55 * extent, 0.6 * extent, 800}, 55}},
        {"straight down", {{0.5 * extent, 0.5 * extent, 12000}, {0.5 * extent, 0.5 * extent, 0}, 60}},
    };
    const auto samples = static_cast<double>(grid.count());
    fmt::print("bytes a sample: pyramid {:.2f}, sky share {:.2f}\n",
               static_cast<double>(pyramid.bytes()) / samples, static_cast<double>(sky.bytes()) / samples);
    fmt::print("{:<14} {:>14} {:>14} {:>8} {:>12} {:>12} {:>10} {:>6}\n", "view", "Talus Mrays/s",
               "Embree Mrays/s", "ratio", "Talus hits", "Embree hits", "steps", "p99");
    for (const auto& view : views) {
        const std::string& name = view.first;
        const render::Camera& camera = view.second;
        int embree_hits = 0;
        const std::vector<double> seconds =
            interleave({{"talus",
                         [&] {
                             exact({terrain, pyramid, camera, width, height, 0, 0, target.framebuffer()});
                             const std::vector<float> wait = target.read_distances(1, 1);
                         }},
                        {"embree", [&] { embree_hits = embree.cast(camera); }}},
                       9);
        const std::vector<float> distances = target.read_distances(width, height);
        const auto talus_hits =
            std::count_if(distances.begin(), distances.end(), [](float d) { return std::isfinite(d); });
        counting({terrain, pyramid, camera, width, height, 0, 0, target.framebuffer()});
        std::vector<float> steps = target.read_details(width, height);
        std::sort(steps.begin(), steps.end());
        double sum = 0;
        for (const float step : steps) sum += step;
        const double rays = static_cast<double>(width) * height * 1e-6;
        fmt::print("{:<14} {:>14.2f} {:>14.2f} {:>8.2f} {:>12} {:>12} {:>10.1f} {:>6}\n", name,
                   rays / seconds[0], rays / seconds[1], seconds[1] / seconds[0], talus_hits, embree_hits,
                   sum / static_cast<double>(steps.size()), steps[steps.size() * 99 / 100]);

        // Shadows: what the shading of the same hits takes longer with them.
        exact({terrain, pyramid, camera, width, height, 0, 0, target.framebuffer()});
        render::ViewSettings lit;
        lit.occlusion = false;
        lit.sun = glm::normalize(glm::dvec3(-0.56, 0.56, 0.61));
        render::ViewSettings unlit = lit;
        unlit.shadows = false;
        const auto shade = [&](const render::ViewSettings& settings) {
            shading.draw({camera, settings, width, height, target.hits(), colour_buffer},
                         render::shaded_ground(terrain, pyramid, sky, settings.view), nullptr);
            std::array<std::byte, 4> wait{};
            colour.read({0, 0, 1, 1}, wait);
        };
        const std::vector<double> shadows =
            interleave({{"shadows", [&] { shade(lit); }},
                        {"none", [&] { shade(unlit); }},
                        {"embree", [&] { embree_hits = embree.cast_shadows(camera, distances, lit.sun); }}},
                       9);
        const double shadow_rays = static_cast<double>(talus_hits) * 1e-6;
        fmt::print("{:<14} {:>14.2f} {:>14.2f} {:>8.2f} {:>12} {:>12}\n", "  its shadows",
                   shadow_rays / (shadows[0] - shadows[1]), shadow_rays / shadows[2],
                   shadows[2] / (shadows[0] - shadows[1]), "", embree_hits);
    }
}

}  // namespace talus::bench
