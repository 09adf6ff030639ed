#pragma once
#include <string>

#include "render/renderer.h"

namespace talus::bench {

/// Draws a picture and writes it to out/papers/NAME.ppm, from which tests/bench/plot_papers.sh makes those of
/// docs/papers.
void write_picture(render::Renderer& renderer, const Terrain& terrain, const render::Camera& camera,
                   const render::ViewSettings& settings, glm::ivec2 size, const std::string& name);

}  // namespace talus::bench
