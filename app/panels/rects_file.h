#pragma once
#include <string>
#include <vector>

#include "app/panels/widgets.h"

namespace talus::app {

/// A file that says where every named widget of the last frame is, a line each: left, top, right, bottom,
/// name.
struct RectsFile {
    std::string path;  ///< empty: none is kept
    std::vector<WidgetRect> written = {};
    /// After a frame's panels: writes it where something moved.
    void keep();
};

}  // namespace talus::app
