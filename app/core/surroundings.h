#pragma once
#include <memory>

#include "app/core/paged_tiles.h"
#include "app/core/still.h"
#include "render/tiled/backdrop.h"
#include "sim/tiled/heights_between.h"

namespace talus::app {

/// What stands around a scene that was cut out of a raster: the rest of that, and the tiles that come for it.
class Surroundings {
  public:
    /// grid: the scene's. first: column and row among the whole's of its first sample. Throws talus::Error as
    /// PagedTiles does.
    Surroundings(std::shared_ptr<const TiledTerrain> whole, int gpu_mib, const Grid& grid, glm::ivec2 first)
        : tiles_(std::move(whole), gpu_mib), backdrop_(tiles_.surface(), grid, first) {}

    PagedTiles& tiles() { return tiles_; }
    const PagedTiles& tiles() const { return tiles_; }
    /// Heights of the whole, by the scene's columns and rows.
    HeightsBetween heights() const;
    render::Backdrop& backdrop() { return backdrop_; }
    const render::Backdrop& backdrop() const { return backdrop_; }

    /// Before a frame of the scene is drawn, with the scene's camera.
    void follow(const render::Camera& camera, glm::ivec2 size, double tolerance_px) {
        if (tiles_.follow(backdrop_.camera_over_tiles(camera), size, tolerance_px)) backdrop_.note_change();
    }
    /// Draws the scene's stills with what stands around; waits for its tiles.
    StillPainter painter(render::Renderer& renderer, const Terrain& terrain,
                         const render::ViewSettings& settings);

  private:
    PagedTiles tiles_;
    render::Backdrop backdrop_;
};

/// What stands around the scene's terrain as it is; null: nothing is known, or it has no place there any
/// more.
std::unique_ptr<Surroundings> surroundings_of(const Scene& scene, const Grid& grid,
                                              const std::optional<Georeference>& place);

}  // namespace talus::app
