#include "sim/io/image_file.h"

#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <algorithm>

#include "sim/gpu/error.h"
#include "sim/io/heightmap.h"
#include "sim/io/heightmap_formats.h"
#include "sim/io/picture.h"

namespace talus {

// Here, because OpenImageIO knows the pictures' endings.
std::filesystem::path with_ending(const std::filesystem::path& path, const std::string& ending) {
    const std::string given = ending_of(path);
    const std::vector<std::string> ours = readable_endings();
    // "png:png;tiff:tif,tiff" and so on.
    static const std::string pictures = std::string(OIIO::get_string_attribute("extension_list")) + ";";
    const auto names_a_picture = [&] {
        for (std::size_t at = pictures.find(given.substr(1)); at != std::string::npos;
             at = pictures.find(given.substr(1), at + 1)) {
            const char before = at > 0 ? pictures[at - 1] : ';';
            const char behind = pictures[at + given.size() - 1];
            if ((before == ':' || before == ',') && (behind == ',' || behind == ';')) return true;
        }
        return false;
    };
    const bool known = given.size() > 1 && (given == ".obj" || names_a_picture() ||
                                            std::find(ours.begin(), ours.end(), given) != ours.end());
    return known ? path : std::filesystem::path(path.string() + ending);
}

void write_rgb(const std::filesystem::path& path, int width, int height,
               const std::vector<std::uint8_t>& rgb) {
    if (ending_of(path) != ".png")
        throw Error(fmt::format("cannot write the picture '{}': its ending must be .png", path.string()));
    write_encoded(path, OIIO::ImageSpec(width, height, 3, OIIO::TypeDesc::UINT8), rgb.data());
}

void write_depth(const std::filesystem::path& path, int width, int height, const std::vector<float>& depth) {
    if (ending_of(path) != ".exr")
        throw Error(fmt::format("cannot write the depth '{}': its ending must be .exr", path.string()));
    OIIO::ImageSpec spec(width, height, 1, OIIO::TypeDesc::FLOAT);
    spec.channelnames = {"Z"};
    spec.attribute("compression", "zip");
    write_encoded(path, spec, depth.data());
}

}  // namespace talus
