#pragma once
#include <string>
#include <vector>

#include "render/camera.h"

namespace talus::app {

/// A way of the camera through keys, as a TOML file tells it:
///
///     [[key]]
///     eye = [9000, 9000, 1500]
///     target = [15000, 13000, 600]
///     fov_deg = 50                 # unless given, the scene's
///
/// Throws talus::Error that names the file and the key where something is missing.
std::vector<render::Camera> read_keys(const std::string& path, double fov_deg);

/// `frames` cameras along the keys, through all of them, by Catmull-Rom splines (Catmull & Rom 1974).
std::vector<render::Camera> fly_along(const std::vector<render::Camera>& keys, int frames);

/// `frames` cameras around a place: the camera turned about it in even steps, once around.
std::vector<render::Camera> turn_around(const render::Camera& camera, glm::dvec2 middle, int frames);

}  // namespace talus::app
