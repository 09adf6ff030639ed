#pragma once
#include <map>
#include <utility>
#include <vector>

#include "sim/budget.h"
#include "sim/gpu/buffer.h"
#include "sim/gpu/program.h"
#include "sim/gpu/uniform_block.h"
#include "sim/passes/dab.h"
#include "sim/passes/dab_numbers.h"
#include "sim/passes/dab_region.h"
#include "sim/terrain/terrain.h"

namespace talus {

/// A rectangle of tiles: the first one, and how many across and down.
struct TileBlock {
    glm::ivec2 first;
    glm::ivec2 size;
};
/// The rectangle that tiles as Tiles::touched_by lists them fill; at least one.
TileBlock tile_block(const Tiles& tiles, const std::vector<int>& touched);

/// Sets what every pass of a dab needs (shaders/sim/dab.glsl): the grid, and the dab's numbers; binds the
/// painted layer. A dab by the mask needs one that was painted.
void set_dab(gpu::Program& program, const Terrain& terrain, const gpu::UniformBlock<DabNumbers>& numbers);

/// Applies dabs, and books per tile what they add and take (law 3).
class Brush {
  public:
    explicit Brush(const Terrain& terrain);
    /// Touches only the tiles that the dab reaches. `stamp`: heights 0 to 1; a dab of it does
    /// nothing without.
    void dab(Terrain& terrain, const Dab& dab, const gpu::Texture* stamp = nullptr);
    /// Puts what an erode dab made of its window in place of the ground there. `settled`: metres of regolith
    /// that a metre of its load becomes; 0: the load stays on its way.
    void take_over(Terrain& terrain, const Dab& dab, const Terrain& eroded, double settled);

    /// Whether what follows counts as wear and deposition by hand.
    void count_wear(bool counts) { counts_wear_ = counts; }

    /// Of solid that came and went.
    Book book();

  private:
    gpu::Program& program_of(BrushMode mode, bool worn);
    /// Runs the dab's program on the samples that it can change; `set` sets what its mode needs.
    template <typename Set>
    void run(Terrain& terrain, const Dab& dab, Set&& set);

    gpu::Buffer book_;  // metres of bedrock in and out, and of regolith, four doubles a tile
    gpu::UniformBlock<DabNumbers> numbers_{"dab numbers"};
    gpu::Buffer path_;
    std::map<std::pair<BrushMode, bool>, gpu::Program> programs_;  // by mode and whether wear is counted
    bool counts_wear_ = false;
};

}  // namespace talus
