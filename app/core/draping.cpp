#include "app/core/draping.h"

namespace talus::app {

Draping open_draping(const std::string& path, const std::optional<Georeference>& ground) {
    Draping draping;
    if (path.empty()) return draping;
    if (io::is_photo(path, ground.has_value()))
        draping.photo = std::make_shared<const io::PhotoFile>(path, ground);
    else
        draping.picture = io::read_colour_image(path);
    return draping;
}

}  // namespace talus::app
