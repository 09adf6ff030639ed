#pragma once
#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace talus::claims {

/// Elements of floats that differ in any bit; where sizes differ, all of them.
template <typename Texel>
std::size_t differing_bits(const std::vector<Texel>& a, const std::vector<Texel>& b) {
    using Words = std::array<std::uint32_t, sizeof(Texel) / sizeof(std::uint32_t)>;
    if (a.size() != b.size()) return std::max(a.size(), b.size());
    std::size_t count = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        count += std::bit_cast<Words>(a[i]) == std::bit_cast<Words>(b[i]) ? 0 : 1;
    return count;
}

}  // namespace talus::claims
