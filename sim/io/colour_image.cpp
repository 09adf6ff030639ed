#include "sim/io/colour_image.h"

#include <fmt/format.h>

#include "sim/gpu/error.h"
#include "sim/io/picture.h"

namespace talus {

ColourImage read_colour_image(const std::filesystem::path& path) {
    const auto input = open_picture(path);
    const OIIO::ImageSpec& spec = input->spec();
    if (spec.nchannels == 2 || spec.nchannels > 4)
        throw Error(fmt::format("'{}' has {} channels, a picture in colours has 1, 3 or 4", path.string(),
                                spec.nchannels));
    if (spec.format.is_floating_point())
        throw Error(fmt::format("'{}' holds floats, a picture in colours holds 8 or 16 bits a channel",
                                path.string()));
    ColourImage image{spec.width, spec.height, {}};
    const std::size_t pixels = static_cast<std::size_t>(spec.width) * spec.height;
    const auto channels = static_cast<std::size_t>(spec.nchannels);
    std::vector<std::uint8_t> read(pixels * channels);
    if (!input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::UINT8, read.data()))
        throw Error(fmt::format("'{}' cannot be read: {}", path.string(), input->geterror()));
    image.rgba.resize(4 * pixels);
    for (std::size_t i = 0; i < pixels; ++i) {
        for (std::size_t c = 0; c < 3; ++c)
            image.rgba[4 * i + c] = read[i * channels + (channels == 1 ? 0 : c)];
        image.rgba[4 * i + 3] = 255;
    }
    return image;
}

}  // namespace talus
