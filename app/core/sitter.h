#pragma once
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "app/core/still.h"
#include "app/core/workspace.h"
#include "sim/gpu/context.h"

namespace talus::app {

/// What pictures of terrain in tiles were made of, all since it was opened.
struct TiledFigures {
    std::size_t drawn = 0;         ///< tiles, at most
    double asked_px = 0;           ///< error that was asked for
    double tolerance_px = 0;       ///< the largest one that there was room for
    std::size_t device_bytes = 0;  ///< that tiles hold, whether drawn or not
};

/// A terrain that sits for stills: held as a whole, or in tiles.
struct Sitter {
    Grid grid;
    float lowest_m = 0;
    float highest_m = 0;
    double highest_around_m = 0;  ///< of what stands around too
    std::string method;
    explicit Sitter(Parameters of_scene) : view(std::move(of_scene)) {}
    Parameters view;  ///< of the scene
    int samples = 1;  ///< a pixel
    std::vector<render::Legend> legends;
    std::vector<std::string> notes;
    std::vector<NamedCamera> cameras;  ///< that its document keeps
    StillPainter painter;
    std::function<TiledFigures()> tiles;  ///< null: it is held as a whole
    std::function<double()> photo_px;     ///< texels of the photo are at most so wide; null: it has none
    std::shared_ptr<void> held;           ///< what the painter draws from
};

/// Opens what is asked for, in tiles where is_in_tiles() says so. Throws talus::Error where that cannot be.
Sitter make_sitter(const SceneRequest& request, const gpu::Device& device);

}  // namespace talus::app
