#include "app/core/tile_room.h"

#include <fmt/format.h>

#include <algorithm>

#include "render/tiled/tile_nodes.h"
#include "sim/error.h"

namespace talus::app {
int slots_within(const TileRoom& room, const TileTree& tree, std::size_t bytes_of_slot) {
    const std::size_t all = static_cast<std::size_t>(room.mib) << 20;
    const std::size_t beside = std::min(all, render::TileNodes::bytes_of(tree));
    const std::size_t slots = std::min((all - beside) / bytes_of_slot, tree.count() + 1);
    const std::size_t coarsest = tree.coarsest_tiles().size();
    if (slots <= coarsest)
        throw Error(
            fmt::format("{} = {} holds {} tiles of '{}', which needs more than the {} of its coarsest level",
                        room.parameter, room.mib, slots, room.file.string(), coarsest));
    return static_cast<int>(slots);
}

}  // namespace talus::app
