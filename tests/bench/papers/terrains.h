#pragma once
#include <string>
#include <vector>

#include "render/camera.h"
#include "sim/terrain/grid.h"

namespace talus::bench {

/// A terrain of the kinds that Ammann, Génevaux & Dischler 2010 measure on, at their sizes.
struct PaperTerrain {
    std::string name;
    Grid grid;
    std::vector<float> heights;
};

/// Generated: high_amplitude at 2048², mountains (in the place of their Mont Blanc) and spectrogram at 4096²,
/// and paper_terrain_of(1024).
/// Measured: where TALUS_DATA names the folder of real elevation files, coast at 4096² with generated detail.
std::vector<std::string> paper_terrain_names();
PaperTerrain paper_terrain(const std::string& name);

/// `mountains` of this many samples a side on 20,480 m, with 2,500 m of relief.
PaperTerrain paper_terrain_of(int side);

/// A flight over a terrain, `frames` cameras: a sixth of its relief above the ground at five places, looking
/// at its middle.
std::vector<render::Camera> paper_flight(const PaperTerrain& terrain, int frames);

/// A walk: 1/500 of the relief above the ground at as many places, looking at its middle along the horizon.
std::vector<render::Camera> paper_walk(const PaperTerrain& terrain, int frames);

/// Along the ground: their "grazing view angle".
render::Camera grazing_view(const PaperTerrain& terrain);

}  // namespace talus::bench
