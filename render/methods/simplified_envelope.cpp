#include "render/methods/simplified_envelope.h"

#include <algorithm>
#include <chrono>

#include "render/methods/simplified_block.h"

namespace talus::render {
namespace {

constexpr int blocks_across = tile_samples / glsl::envelope_patches;
constexpr std::size_t tile_words =
    static_cast<std::size_t>(blocks_across) * blocks_across * glsl::block_words;
// A thread takes about a second for as many.
constexpr int tiles_of_a_job = 64;
constexpr std::uint32_t no_mesh = 0xffffffff;
// What is asked of every device (sim/gpu/context.cpp). Larger terrains are drawn unsimplified.
constexpr std::size_t largest_buffer = std::size_t{1} << 27U;

}  // namespace

void SimplifiedEnvelope::follow(const Terrain& terrain, const Envelope& envelope, bool wanted) {
    make_room(terrain, wanted);
    step(terrain, envelope, false);
}

void SimplifiedEnvelope::finish(const Terrain& terrain, const Envelope& envelope, bool wanted) {
    make_room(terrain, wanted);
    while (step(terrain, envelope, true)) {
    }
}

void SimplifiedEnvelope::make_room(const Terrain& terrain, bool wanted) {
    const auto tiles = static_cast<std::size_t>(terrain.tiles.count());
    const std::size_t bytes = tiles * tile_words * sizeof(std::uint32_t);
    wanted = wanted && bytes <= largest_buffer;
    if (grid_ == terrain.grid() && wanted_ == wanted) return;
    give_up();
    grid_ = terrain.grid();
    wanted_ = wanted;
    triangles_ = gpu::Buffer("simplified blocks", wanted ? bytes : sizeof(std::uint32_t));
    versions_ = gpu::Buffer("versions of simplified tiles", tiles * sizeof(float));
    versions_.fill(0);
    made_.assign(tiles, 0);
    seen_.clear();
    next_ = 0;
    done_.reset();
}

// Returns whether something is left to do.
bool SimplifiedEnvelope::step(const Terrain& terrain, const Envelope& envelope, bool waits) {
    if (!wanted_) return false;
    if (job_.valid()) {
        if (!waits && job_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return true;
        keep(job_.get());
        return true;
    }
    if (ground_readback_.pending()) {
        auto heights = waits ? ground_readback_.wait() : ground_readback_.poll();
        if (!heights) return true;
        coming_.heights = std::move(*heights);
        job_ = std::async(std::launch::async, [job = std::move(coming_), given_up = given_up_]() mutable {
            return simplified(std::move(job), *given_up);
        });
        return true;
    }
    if (versions_readback_.pending()) {
        const auto now = waits ? versions_readback_.wait() : versions_readback_.poll();
        return !now || choose(terrain, *now);
    }
    if (done_ == terrain.tiles.now()) return false;
    asked_ = terrain.tiles.now();
    versions_readback_.start(envelope.versions(), envelope.versions().bytes());
    return true;
}

// Asks for the ground of the next tiles of a row whose meshes are old. A tile that changes from one reading
// to the next waits: its meshes would be old again when they come. Returns whether any tile's are old.
bool SimplifiedEnvelope::choose(const Terrain& terrain, const std::vector<float>& now) {
    const int columns = terrain.tiles.columns();
    const int count = terrain.tiles.count();
    coming_ = {};
    coming_.grid = grid_;
    coming_.columns = columns;
    bool old = false;
    for (int i = 0; i < count; ++i) {
        const int tile = (next_ + i) % count;
        const auto at = static_cast<std::size_t>(tile);
        if (now[at] == made_[at]) continue;
        old = true;
        if (seen_.empty() || now[at] != seen_[at]) continue;
        const bool other_row = !coming_.tiles.empty() && tile / columns != coming_.tiles[0].number / columns;
        if (other_row || coming_.tiles.size() == tiles_of_a_job) break;
        coming_.tiles.push_back({tile, now[at], {}});
    }
    seen_ = now;
    if (!old) done_ = asked_;
    if (coming_.tiles.empty()) return old;
    next_ = (coming_.tiles.back().number + 1) % count;
    const gpu::Region first = terrain.tiles.region(coming_.tiles.front().number);
    const gpu::Region last = terrain.tiles.region(coming_.tiles.back().number);
    // Blocks end at the next tile's first samples.
    coming_.ground = {first.x, first.y, std::min(last.x + last.width + 1, grid_.nx) - first.x,
                      std::min(first.y + first.height + 1, grid_.ny) - first.y};
    // The ground is that of `now` or newer; where it is newer, the envelope's version is too, and its meshes
    // will never be drawn.
    ground_readback_.start(terrain.ground, coming_.ground);
    return true;
}

SimplifiedEnvelope::Job SimplifiedEnvelope::simplified(Job job, const std::atomic<bool>& given_up) {
    const glm::ivec2 patches(job.grid.nx - 1, job.grid.ny - 1);
    std::vector<float> samples;
    for (Tile& tile : job.tiles) {
        if (given_up) return job;
        tile.words.assign(tile_words, 0);
        const glm::ivec2 corner =
            tile_samples * glm::ivec2(tile.number % job.columns, tile.number / job.columns);
        for (int block = 0; block < blocks_across * blocks_across; ++block) {
            std::uint32_t* const words = &tile.words[static_cast<std::size_t>(block) * glsl::block_words];
            words[0] = no_mesh;
            const glm::ivec2 first =
                corner + glsl::envelope_patches * glm::ivec2(block % blocks_across, block / blocks_across);
            const glm::ivec2 size = glm::min(patches - first, glm::ivec2(glsl::envelope_patches));
            if (size.x <= 0 || size.y <= 0) continue;
            samples.clear();
            for (int y = 0; y <= size.y; ++y) {
                const auto row = static_cast<std::size_t>(first.y + y - job.ground.y) * job.ground.width;
                const float* const begin = &job.heights[row + (first.x - job.ground.x)];
                samples.insert(samples.end(), begin, begin + size.x + 1);
            }
            const auto mesh = simplify_block(samples, size, {job.grid.dx, job.grid.dy}, glsl::block_words);
            std::copy(mesh.begin(), mesh.end(), words);
        }
    }
    return job;
}

void SimplifiedEnvelope::keep(const Job& job) {
    for (const Tile& tile : job.tiles) {
        const auto at = static_cast<std::size_t>(tile.number);
        triangles_.write(at * tile_words * sizeof(std::uint32_t), std::as_bytes(std::span(tile.words)));
        versions_.write(at * sizeof(float), std::as_bytes(std::span(&tile.version, 1)));
        made_[at] = tile.version;
    }
}

void SimplifiedEnvelope::give_up() {
    *given_up_ = true;
    if (job_.valid()) job_.wait();
    job_ = {};
    versions_readback_.cancel();
    ground_readback_.cancel();
    given_up_ = std::make_shared<std::atomic<bool>>(false);
}

}  // namespace talus::render
