#pragma once
#include <cstddef>
#include <functional>
#include <glm/glm.hpp>
#include <map>
#include <optional>
#include <vector>

#include "app/core/tiled_terrain.h"

namespace talus::bench {

/// A tiled terrain's finest level as one bilinear surface, read where it is asked for, in double precision.
class FinestSurface {
  public:
    /// The terrain must outlive it.
    explicit FinestSurface(const app::TiledTerrain& terrain);

    /// None beside the terrain.
    std::optional<double> height_m(glm::dvec2 place_m);
    /// Visits a ray where it crosses columns and rows of samples, with the surface's height there. Left out
    /// are tiles that the ray stays above. length_m: may be infinite.
    void along(glm::dvec3 eye, glm::dvec3 way, double length_m,
               const std::function<void(glm::dvec3 place, double height_m)>& visit);

    /// Lets go of what was read.
    void forget() { held_.clear(); }

  private:
    const std::vector<float>& heights_of(const TileId& tile);
    TileId tile_under(glm::dvec2 patch) const;

    const app::TiledTerrain& terrain_;
    const Grid& grid_;
    ReadSamples read_;
    std::map<std::size_t, std::vector<float>> held_;  // by TileTree::index_of()
};

}  // namespace talus::bench
