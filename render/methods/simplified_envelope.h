#pragma once
#include <atomic>
#include <future>
#include <memory>
#include <optional>
#include <vector>

#include "render/methods/envelope.h"
#include "sim/gpu/readback.h"

namespace talus::render {

namespace glsl {
#include "render/uniform_blocks.glsl"
}  // namespace glsl

/// Simplified meshes of the envelope's blocks, made by a thread from ground that is read back without
/// waiting. A tile has them while its envelope is still the one that they were made of: `versions` equals the
/// envelope's.
class SimplifiedEnvelope {
  public:
    SimplifiedEnvelope() = default;
    SimplifiedEnvelope(const SimplifiedEnvelope&) = delete;
    SimplifiedEnvelope& operator=(const SimplifiedEnvelope&) = delete;
    ~SimplifiedEnvelope() { give_up(); }

    /// One step on, once a frame, after the envelope's refresh(). It never waits. With `wanted` false no tile
    /// has meshes.
    void follow(const Terrain& terrain, const Envelope& envelope, bool wanted = true);
    /// Until all tiles were tried. Waits for the device and the thread.
    void finish(const Terrain& terrain, const Envelope& envelope, bool wanted = true);

    /// Words of simplify_block(), 64 a block, zeros after the last; the first is ~0 where the block has none.
    /// Blocks of 8 x 8 a tile, tile after tile.
    const gpu::Buffer& triangles() const { return triangles_; }
    /// A number a tile, as Envelope::versions().
    const gpu::Buffer& versions() const { return versions_; }
    std::size_t bytes() const { return triangles_.bytes() + versions_.bytes(); }

  private:
    struct Tile {
        int number;
        float version;
        std::vector<std::uint32_t> words;
    };
    // Tiles of one row, and the ground from the first to the last.
    struct Job {
        Grid grid;
        int columns = 0;
        gpu::Region ground;
        std::vector<float> heights;
        std::vector<Tile> tiles;
    };
    static Job simplified(Job job, const std::atomic<bool>& given_up);
    bool step(const Terrain& terrain, const Envelope& envelope, bool waits);
    void make_room(const Terrain& terrain, bool wanted);
    bool choose(const Terrain& terrain, const std::vector<float>& now);
    void keep(const Job& job);
    void give_up();

    gpu::Buffer triangles_;
    gpu::Buffer versions_;
    Grid grid_;
    bool wanted_ = false;
    std::vector<float> seen_;            // versions as they were read last
    int next_ = 0;                       // the tile after the last that was tried
    std::vector<float> made_;            // versions of the tiles whose meshes are on the device
    std::optional<std::uint64_t> done_;  // the terrain's changes that all meshes have seen
    std::uint64_t asked_ = 0;
    gpu::Readback versions_readback_;
    gpu::Readback ground_readback_;
    Job coming_;  // its ground is on its way
    std::future<Job> job_;
    std::shared_ptr<std::atomic<bool>> given_up_ = std::make_shared<std::atomic<bool>>(false);
};

}  // namespace talus::render
