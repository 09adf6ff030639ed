#pragma once
#include <memory>
#include <optional>
#include <string>

#include "sim/io/colour_image.h"
#include "sim/io/photo_file.h"

namespace talus::app {

/// What lies over a terrain instead of its materials: a picture that is held as a whole, a photo in tiles, or
/// nothing.
struct Draping {
    io::ColourImage picture{};                     ///< without pixels: none
    std::shared_ptr<const io::PhotoFile> photo{};  ///< null: none
};

/// path: empty for nothing. ground: where the terrain lies on Earth. What lies on Earth too is laid where it
/// does; another picture is stretched over the whole terrain. Throws talus::Error where it cannot be read.
Draping open_draping(const std::string& path, const std::optional<Georeference>& ground);

}  // namespace talus::app
