#include "sim/io/colour_image.h"

#include <OpenImageIO/filesystem.h>
#include <fmt/format.h>

#include "sim/error.h"
#include "sim/io/picture.h"

namespace talus::io {
namespace {

ColourImage all_of(const std::filesystem::path& path, OIIO::ImageInput& input) {
    const OIIO::ImageSpec& spec = input.spec();
    if (spec.nchannels == 2 || spec.nchannels > 4)
        throw Error(fmt::format("'{}' has {} channels, a picture in colours has 1, 3 or 4", path.string(),
                                spec.nchannels));
    if (spec.width < 1 || spec.height < 1 || spec.width > largest_picture_side ||
        spec.height > largest_picture_side)
        throw Error(fmt::format("'{}' has {} x {} pixels, each side must have 1 to {}", path.string(),
                                spec.width, spec.height, largest_picture_side));
    if (spec.format.is_floating_point() || spec.format.size() > 2)
        throw Error(fmt::format("'{}' holds no picture in colours: these have 8 or 16 bits a channel",
                                path.string()));
    ColourImage image{spec.width, spec.height, {}};
    const std::size_t pixels = static_cast<std::size_t>(spec.width) * spec.height;
    const auto channels = static_cast<std::size_t>(spec.nchannels);
    std::vector<std::uint8_t> read(pixels * channels);
    read_bytes(path, input, spec.nchannels, read.data());
    image.rgba.resize(4 * pixels);
    for (std::size_t i = 0; i < pixels; ++i) {
        for (std::size_t c = 0; c < 3; ++c)
            image.rgba[4 * i + c] = read[i * channels + (channels == 1 ? 0 : c)];
        image.rgba[4 * i + 3] = 255;
    }
    return image;
}

}  // namespace

ColourImage read_colour_image(const std::filesystem::path& path) {
    return all_of(path, *open_picture(path));
}

ColourImage decode_png(std::string_view bytes, const std::string& name) {
    OIIO::Filesystem::IOMemReader memory(const_cast<char*>(bytes.data()), bytes.size());
    const auto input = OIIO::ImageInput::open(name + ".png", nullptr, &memory);
    if (!input) throw Error(fmt::format("the picture '{}' cannot be read: {}", name, OIIO::geterror()));
    return all_of(name, *input);
}

}  // namespace talus::io
