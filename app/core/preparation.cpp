#include "app/core/preparation.h"

#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cmath>
#include <memory>
#include <utility>

#include "app/core/tile_sketch.h"

namespace talus::app {
namespace {

// Linux keeps this for each thread, and threads that it begins have it too.
void let_others_go_first() {
    constexpr int niceness = 10;
    ::setpriority(PRIO_PROCESS, static_cast<id_t>(::gettid()), niceness);
}

}  // namespace

Preparation::Preparation(Session& session, std::function<void(const std::string&)> note)
    : session_(session), note_(std::move(note)) {}

void Preparation::poll() {
    const std::optional<TiledRequest> needed = session_.unready();
    // First: what has ended meanwhile is not handed to another scene.
    if (begun_ && !(needed && is_same(*needed, *begun_))) {
        work_.cancel();
        begun_.reset();
    }
    if (begun_) {
        try {
            work_.poll();
        } catch (...) {
            refuse();
            throw;
        }
        if (!work_.busy()) begun_.reset();
    } else if (needed && refused_ != session_.terrain_number()) {
        refused_.reset();
        begun_ = needed;
        begin(*needed);
    }
}

void Preparation::give_up() {
    if (!begun_) return;
    note_(fmt::format("'{}' is not made ready: what is shown stays as it is", begun_->path));
    work_.cancel();
    refuse();
}

void Preparation::refuse() {
    begun_.reset();
    refused_ = session_.terrain_number();
}

void Preparation::begin(const TiledRequest& tiles) {
    const PagedTiles* const shown = session_.tiles();
    if (shown && !shown->terrain().instead) return measure(tiles);
    const auto make = [this, tiles](const Progress& progress) -> Work::Then {
        let_others_go_first();
        std::shared_ptr<TiledTerrain> sketch;
        if (const io::TiledFile file(tiles.path, tiles.import); needs_overviews(file)) {
            make_overviews(file, [&](const std::string&) { return progress; });
            sketch = std::make_shared<TiledTerrain>(sketch_of({tiles.path, tiles.import}));
        }
        return [this, tiles, sketch] {
            if (sketch) show(std::move(*sketch));
            measure(tiles);
        };
    };
    work_.start(fmt::format("Making overviews of '{}'", tiles.path), make);
}

void Preparation::measure(const TiledRequest& tiles) {
    const auto make = [this, tiles](const Progress& progress) -> Work::Then {
        let_others_go_first();
        auto ready =
            std::make_shared<TiledTerrain>(open_tiled(tiles, [&](const std::string&) { return progress; }));
        return [this, tiles, ready] {
            show(std::move(*ready));
            note_(fmt::format("'{}' is measured: bounds on the error of its tiles are known", tiles.path));
        };
    };
    work_.start(fmt::format("Measuring the tiles of '{}'", tiles.path), make);
}

void Preparation::show(TiledTerrain tiles) {
    const std::vector<std::string> notes = session_.take_tiles(std::move(tiles));
    for (const std::string& note : notes) note_("note: " + note);
}

bool Preparation::take_progress() {
    const int percent = work_.busy() ? static_cast<int>(std::floor(100 * work_.share().value_or(0))) : -1;
    return percent != std::exchange(shown_percent_, percent);
}

}  // namespace talus::app
