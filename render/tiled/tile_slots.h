#pragma once
#include <cstdint>
#include <functional>
#include <optional>
#include <unordered_map>
#include <vector>

#include "render/tiled/tile_choice.h"

namespace talus::render {

/// Which tile is in which slot of a place on the device, and which of them a picture shows. Tiles of the
/// coarsest level stay; of the others those go first that were not shown for the longest time (Dick, Krüger &
/// Westermann 2009, section 4).
class TileSlots {
  public:
    /// bounds: of all tiles of the tree. slots: more than the tree's coarsest tiles, which must be put()
    /// before the first look(). Throws talus::Error where they are too few.
    TileSlots(TileTree tree, std::vector<TileBounds> bounds, int slots);

    const TileTree& tree() const { return tree_; }
    const std::vector<TileBounds>& bounds() const { return bounds_; }
    int count() const { return static_cast<int>(slots_.size()); }
    /// The slot that a tile is in, or -1.
    int slot_of(const TileId& tile) const;
    /// The tile in a slot; none: it is free.
    std::optional<TileId> tile_in(int slot) const;

    /// Gives a tile a slot, a free one or another tile's. Returns the slot.
    int put(const TileId& tile);
    /// The same for a tile that is not wanted yet, where there is a slot that neither the last two looks
    /// asked for nor a look ahead has a use for; else it returns none.
    std::optional<int> put_aside(const TileId& tile);
    /// Takes all tiles away but those of the coarsest level.
    void clear();

    /// Chooses what a picture shows (choose_tiles()).
    const TileChoice& look(const Camera& camera, glm::ivec2 size, double tolerance_px);
    /// What was chosen last.
    const TileChoice& choice() const { return choice_; }
    /// Which tiles a picture would want that may come after the last one; the worst first, as many as
    /// put_aside() has slots for. Those that are there already are kept for it.
    std::vector<TileId> look_ahead(const Camera& camera, glm::ivec2 size, double tolerance_px);

  private:
    struct Slot {
        TileId tile{-1, 0, 0};
        std::uint64_t shown = 0;  // twice the look that showed it last, and 1 where it was asked for
    };

    TileChoice choose(const Camera& camera, glm::ivec2 size, double tolerance_px) const;
    int slot_to_fill() const;
    bool is_spare(const Slot& slot) const;

    TileTree tree_;
    std::vector<TileBounds> bounds_;
    std::vector<Slot> slots_;
    std::unordered_map<std::size_t, int> slot_of_tile_;  // by TileTree::index_of()
    std::uint64_t looks_ = 0;
    TileChoice choice_;
};

}  // namespace talus::render
