#pragma once
#include <atomic>
#include <memory>
#include <optional>
#include <string>

#include "app/core/still.h"
#include "app/core/tiled_terrain.h"
#include "render/tiled/tile_paging.h"
#include "render/tiled/tiled_renderer.h"

namespace talus::app {

/// A terrain in tiles while somebody looks at it: its pictures, and the tiles that come for them.
class Overflight {
  public:
    /// Reads the coarsest tiles. Throws talus::Error where that fails, or gpu_mib (of the device's memory) is
    /// too little.
    Overflight(std::shared_ptr<const TiledTerrain> terrain, int gpu_mib, const io::ColourImage& texture);

    const TiledTerrain& terrain() const { return *terrain_; }
    const render::TiledSurface& surface() const { return surface_; }
    const render::TiledRenderer& renderer() const { return renderer_; }

    /// Draws what is there, without waiting for a file. Drawn::nothing: the picture would be the one before.
    render::Drawn draw(const render::Camera& camera, const render::ViewSettings& settings, glm::ivec2 size);
    bool refine(int samples) { return renderer_.refine(surface_, samples); }
    /// The next picture is drawn anew.
    void forget() { drawn_.reset(); }
    /// Draws stills, with all tiles there that can be read; waits for them.
    StillPainter painter(const render::ViewSettings& settings);

    /// Whether a frame is to follow without anybody's doing.
    bool has_news() const { return paging_.has_news(); }
    /// True while tiles are read.
    bool awaits_tiles() const { return paging_.reads(); }
    /// Of the last picture.
    std::size_t drawn_tiles() const { return drawn_ ? drawn_->tiles.size() : 0; }
    std::size_t awaited_tiles() const { return paging_.on_their_way(); }
    /// What the status line says of the last picture's tiles.
    std::string state() const;
    /// What is to be said of reading, once.
    std::optional<std::string> take_message();

  private:
    struct Picture {
        render::Camera camera;
        render::ViewSettings settings;
        glm::ivec2 size;
        std::vector<render::TileNode> nodes;
        std::vector<TileId> tiles;
        bool operator==(const Picture&) const = default;
    };

    std::shared_ptr<const TiledTerrain> terrain_;
    render::TiledSurface surface_;
    render::TiledRenderer renderer_;
    std::optional<Picture> drawn_;
    double asked_px_ = 0;
    double tolerance_px_ = 0;
    double still_px_ = 0;                // tolerance of the still that is drawn
    std::atomic<bool> changed_ = false;  // the file, since it was opened
    bool change_told_ = false;
    render::TilePaging paging_;  // last: its thread ends before what it looks at goes
};

}  // namespace talus::app
