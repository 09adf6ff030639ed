#pragma once
#include "app/core/session.h"

namespace talus::app {

/// Saves the picture that the window shows, at full size with its legend, under the first free name in the
/// folder where Talus was started: talus-0001.png. Returns the name.
std::string save_picture(Session& session, glm::ivec2 size);

}  // namespace talus::app
