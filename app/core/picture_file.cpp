#include "app/core/picture_file.h"

#include <fmt/format.h>
#include <unistd.h>

#include <filesystem>

#include "app/core/scene_file.h"
#include "app/core/still.h"
#include "sim/io/image_file.h"

namespace talus::app {

std::string free_name(const Session& session, const std::string& ending) {
    const SceneRequest& request = session.request();
    std::filesystem::path folder = std::filesystem::path(!session.path().empty()    ? session.path()
                                                         : !request.input.empty()   ? request.input
                                                         : is_scene(request.preset) ? request.preset
                                                                                    : "")
                                       .parent_path();
    // A share that is read alone.
    if (!folder.empty() && ::access(folder.c_str(), W_OK) != 0) folder.clear();
    const auto named = [&](int number) {
        return (folder / fmt::format("talus-{:04}{}", number, ending)).string();
    };
    int number = 1;
    while (std::filesystem::exists(named(number))) ++number;
    return named(number);
}

std::string save_picture(Session& session, glm::ivec2 size) {
    std::string path = free_name(session, ".png");
    const Still still = session.still(size);
    io::write_rgb(path, size.x, size.y, still.rgb);
    return path;
}

}  // namespace talus::app
