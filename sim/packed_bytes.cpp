#include "sim/packed_bytes.h"

#include <fmt/format.h>
#include <zstd.h>

#include "sim/error.h"

namespace talus {
namespace {

constexpr int packing_level = 1;

std::size_t checked(std::size_t result) {
    if (ZSTD_isError(result)) throw Error(fmt::format("packing failed: {}", ZSTD_getErrorName(result)));
    return result;
}

}  // namespace

PackedBytes::PackedBytes(std::span<const std::byte> words) : unpacked_bytes_(words.size()) {
    const std::size_t count = words.size() / 4;
    std::vector<std::byte> planes(words.size());
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t plane = 0; plane < 4; ++plane) planes[plane * count + i] = words[4 * i + plane];
    std::vector<std::byte> room(ZSTD_compressBound(planes.size()));
    const std::size_t packed =
        checked(ZSTD_compress(room.data(), room.size(), planes.data(), planes.size(), packing_level));
    packed_.assign(room.begin(), room.begin() + static_cast<std::ptrdiff_t>(packed));
}

std::vector<std::byte> PackedBytes::unpack() const {
    std::vector<std::byte> planes(unpacked_bytes_);
    if (packed_.empty()) return planes;
    checked(ZSTD_decompress(planes.data(), planes.size(), packed_.data(), packed_.size()));
    const std::size_t count = planes.size() / 4;
    std::vector<std::byte> words(planes.size());
    for (std::size_t plane = 0; plane < 4; ++plane)
        for (std::size_t i = 0; i < count; ++i) words[4 * i + plane] = planes[plane * count + i];
    return words;
}

}  // namespace talus
