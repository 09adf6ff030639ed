#pragma once
#include <string>

namespace talus::app {
class Session;

/// Whether a path is of a scene: it ends in .toml.
bool is_scene(const std::string& path);

/// Whether the session's terrain was generated, and not cropped, turned or resampled since, so that a scene
/// can make it again.
bool can_be_scene(const Session& session);

/// The session as a scene: its generator, its events, all parameters that were given but those of the
/// machine: as they are now, those that events or tables set as they were at the start. What was done to the
/// ground, springs, tables and rasters are in documents alone. Throws talus::Error where can_be_scene() is
/// false.
std::string scene_text(const std::string& title, const Session& session);

}  // namespace talus::app
