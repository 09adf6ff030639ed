#pragma once
#include <OpenImageIO/imageio.h>

#include <filesystem>

namespace talus::io {

/// Encodes a picture in memory by the path's ending and writes it atomically. Throws talus::Error.
void write_encoded(const std::filesystem::path& path, const OIIO::ImageSpec& spec, const void* pixels);

/// Opens a picture and checks its claims, but for its sides, before anything is allocated for it. Throws
/// talus::Error.
std::unique_ptr<OIIO::ImageInput> open_picture(const std::filesystem::path& path);

/// Reads all of the first channels, 8 bits each, without a word of the libraries on stderr. Throws
/// talus::Error.
void read_bytes(const std::filesystem::path& path, OIIO::ImageInput& input, int channels,
                std::uint8_t* bytes);

/// A number that Talus wrote as a text attribute. Throws talus::Error when it is not one.
double number_attribute(const std::filesystem::path& path, const OIIO::ImageSpec& spec, const char* name,
                        double fallback);

}  // namespace talus::io
