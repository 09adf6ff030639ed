#pragma once
#include <cstdint>
#include <memory>
#include <optional>

#include "app/core/paged_tiles.h"
#include "app/core/still.h"
#include "render/tiled/tiled_renderer.h"

namespace talus::app {

/// A terrain in tiles while somebody looks at it: its pictures, and the tiles that come for them.
class Overflight {
  public:
    /// picture: draped over it; without pixels: none. Throws talus::Error as PagedTiles does.
    Overflight(std::shared_ptr<const TiledTerrain> terrain, int gpu_mib, const io::ColourImage& picture);

    const TiledTerrain& terrain() const { return tiles_.terrain(); }
    const render::TiledSurface& surface() const { return tiles_.surface(); }
    PagedTiles& tiles() { return tiles_; }
    const PagedTiles& tiles() const { return tiles_; }
    const render::TiledRenderer& renderer() const { return renderer_; }

    /// Draws what is there, without waiting for a file. Drawn::nothing: the picture would be the one before.
    render::Drawn draw(const render::Camera& camera, const render::ViewSettings& settings, glm::ivec2 size);
    bool refine(int samples) { return renderer_.refine(tiles_.surface(), samples); }
    /// A photo over it from now on (TiledRenderer::lay()).
    void lay(const render::LaidPhoto& photo) {
        renderer_.lay(photo);
        photo_changes_ = photo.changes;
    }
    /// The next picture is drawn anew.
    void forget() { drawn_.reset(); }
    /// Draws stills, with all tiles there that can be read; waits for them.
    StillPainter painter(const render::ViewSettings& settings);

  private:
    struct Picture {
        render::Camera camera;
        render::ViewSettings settings;
        glm::ivec2 size;
        std::uint64_t photo;
        bool operator==(const Picture&) const = default;
    };

    PagedTiles tiles_;
    render::TiledRenderer renderer_;
    std::uint64_t photo_changes_ = 0;
    std::optional<Picture> drawn_;
};

}  // namespace talus::app
