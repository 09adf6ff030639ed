#pragma once
#include <cstddef>
#include <span>
#include <vector>

namespace talus {

/// 32-bit words packed without loss: first bytes together, then second ones and so on, as neighbouring
/// samples share their high bytes, then Zstandard at a fast level.
class PackedBytes {
  public:
    PackedBytes() = default;
    /// May run on any thread. The number of bytes must be a multiple of four. Throws talus::Error when it
    /// cannot.
    explicit PackedBytes(std::span<const std::byte> words);

    /// The same bytes again.
    std::vector<std::byte> unpack() const;
    /// Memory that it takes.
    std::size_t bytes() const { return packed_.size(); }

  private:
    std::vector<std::byte> packed_;
    std::size_t unpacked_bytes_ = 0;
};

}  // namespace talus
