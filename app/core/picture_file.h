#pragma once
#include "app/core/session.h"

namespace talus::app {

/// The first free name beside the project, talus-0001 with this ending; where there is none yet, beside the
/// file that was opened, or in the folder where Talus was started.
std::string free_name(const Session& session, const std::string& ending);

/// Saves the picture that the window shows, at full size with its legend, under a free name. Returns the
/// name.
std::string save_picture(Session& session, glm::ivec2 size);

}  // namespace talus::app
