#pragma once
#include <atomic>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/core/tiled_terrain.h"
#include "render/tiled/tile_paging.h"

namespace talus::app {

/// A terrain in tiles on the device, and the tiles that come for pictures of it.
class PagedTiles {
  public:
    /// Reads the coarsest tiles. Throws talus::Error where that fails, or gpu_mib (of the device's memory) is
    /// too little.
    PagedTiles(std::shared_ptr<const TiledTerrain> terrain, int gpu_mib);

    const TiledTerrain& terrain() const { return *terrain_; }
    const render::TiledSurface& surface() const { return surface_; }

    /// Once a frame, before it is drawn: looks at what is there, without waiting for a file. False: at the
    /// same tiles as before.
    bool follow(const render::Camera& camera, glm::ivec2 size, double tolerance_px);
    /// Before a still is drawn in parts: finds the one tolerance for all of them, so that levels meet between
    /// them.
    void begin_still(const render::Camera& camera, glm::ivec2 size, double tolerance_px);
    /// Before a part is drawn: waits until all its tiles are there that can be read. Throws talus::Error
    /// where none comes for long.
    void wait_for_still(const render::Camera& camera, glm::ivec2 size);

    /// Whether a frame is to follow without anybody's doing.
    bool has_news() const { return paging_.has_news(); }
    /// True while tiles are read.
    bool awaits_tiles() const { return paging_.reads(); }
    /// Of the last look.
    std::size_t drawn_tiles() const { return drawn_.size(); }
    std::size_t awaited_tiles() const { return paging_.on_their_way(); }
    double tolerance_px() const { return tolerance_px_; }
    /// What the status line says of the last look.
    std::string state() const;
    /// What is to be said of reading, once.
    std::optional<std::string> take_message();

  private:
    std::shared_ptr<const TiledTerrain> terrain_;
    render::TiledSurface surface_;
    std::vector<render::TileNode> nodes_;
    std::vector<TileId> drawn_;
    double asked_px_ = 0;
    double tolerance_px_ = 0;
    double still_px_ = 0;                // tolerance of the still that is drawn
    std::atomic<bool> changed_ = false;  // the file, since it was opened
    bool change_told_ = false;
    render::TilePaging paging_;  // last: its thread ends before what it looks at goes
};

}  // namespace talus::app
