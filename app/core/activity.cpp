#include "app/core/activity.h"

#include <algorithm>
#include <bit>
#include <vector>

#include "app/core/wall_clock.h"

namespace talus::app {

void Activity::follow(const Tiles& tiles) {
    if (const auto words = stamps_.poll()) {
        std::vector<std::uint32_t> stamps(words->size());
        std::transform(words->begin(), words->end(), stamps.begin(),
                       [](float word) { return std::bit_cast<std::uint32_t>(word); });
        counts_ = {};
        for (std::size_t at = 0; at < stamps.size(); at += tile_changes::tile_kinds) {
            counts_.slope_tiles += tiles.has_changed(Tiles::ground, since_, &stamps[at]) ? 1 : 0;
            counts_.water_tiles += tiles.has_changed(Tiles::water, since_, &stamps[at]) ? 1 : 0;
        }
        since_ = asked_at_;
    }
    if (stamps_.pending() || wall_clock_s() - asked_at_s_ < 0.5) return;
    asked_at_s_ = wall_clock_s();
    asked_at_ = tiles.reader_now();
    stamps_.start(tiles.stamps(), tiles.stamps().bytes());
}

void Activity::forget() {
    stamps_.cancel();
    since_ = asked_at_ = {};
    counts_ = {};
}

}  // namespace talus::app
