#include "sim/io/image_file.h"

#include <fmt/format.h>

#include "sim/error.h"
#include "sim/io/endings.h"
#include "sim/io/heightmap.h"
#include "sim/io/picture.h"

namespace talus::io {

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

}  // namespace talus::io
