#include "app/core/picture_file.h"

#include <fmt/format.h>

#include <filesystem>

#include "app/core/still.h"
#include "sim/io/image_file.h"

namespace talus::app {

std::string save_picture(Session& session, glm::ivec2 size) {
    int number = 1;
    while (std::filesystem::exists(fmt::format("talus-{:04}.png", number))) ++number;
    std::string path = fmt::format("talus-{:04}.png", number);
    const Still still = session.still(size);
    io::write_rgb(path, size.x, size.y, still.rgb);
    return path;
}

}  // namespace talus::app
