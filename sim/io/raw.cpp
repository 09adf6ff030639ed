// Headerless samples: 16-bit integers (.r16, .raw) or 32-bit floats (.r32, .raw).
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>

#include "sim/error.h"
#include "sim/io/atomic_file.h"
#include "sim/io/endings.h"
#include "sim/io/heightmap_formats.h"

namespace talus::io {
namespace {

namespace fs = std::filesystem;

template <typename Word>
Word swapped(Word word) {
    if constexpr (sizeof(Word) == 2)
        return __builtin_bswap16(word);
    else
        return __builtin_bswap32(word);
}

template <typename Word>
float value_of(Word word) {
    if constexpr (sizeof(Word) == 2)
        return static_cast<float>(word);
    else
        return std::bit_cast<float>(word);
}

// Whether it can be a height in metres. The wrong order makes numbers of any size of a float, and NaN.
bool is_plausible(float height) {
    const float size = std::abs(height);
    return height == 0 || (size > 1e-6F && size < 1e6F);
}

// Whether any sample can be a height, in either byte order.
template <typename Word>
bool holds_heights(const std::vector<Word>& words) {
    return std::any_of(words.begin(), words.end(), [](Word word) {
        return is_plausible(value_of(word)) || is_plausible(value_of(swapped(word)));
    });
}

// Guesses the byte order: the one in which more samples are plausible heights or, on a tie, the smoother one.
// A sample that is implausible in both orders does not count: a NaN is no evidence of swapped bytes.
template <typename Word>
bool is_big_endian(const std::vector<Word>& words, int nx) {
    std::int64_t more_as_big = 0;
    double rough_as_little = 0;
    double rough_as_big = 0;
    for (std::size_t i = 0; i < words.size(); ++i) {
        const float little = value_of(words[i]);
        const float big = value_of(swapped(words[i]));
        more_as_big += (is_plausible(big) ? 1 : 0) - (is_plausible(little) ? 1 : 0);
        if (i % static_cast<std::size_t>(nx) == 0) continue;
        const float little_before = value_of(words[i - 1]);
        const float big_before = value_of(swapped(words[i - 1]));
        const bool all_plausible = is_plausible(little) && is_plausible(big) && is_plausible(little_before) &&
                                   is_plausible(big_before);
        if (!all_plausible) continue;
        rough_as_little += std::abs(static_cast<double>(little) - little_before);
        rough_as_big += std::abs(static_cast<double>(big) - big_before);
    }
    return more_as_big != 0 ? more_as_big > 0 : rough_as_big < rough_as_little;
}

template <typename Word>
std::vector<float> decode(const fs::path& path, const std::string& bytes, RawLayout& layout, bool guess_order,
                          std::vector<std::string>& notes) {
    std::vector<Word> words(bytes.size() / sizeof(Word));
    std::memcpy(words.data(), bytes.data(), words.size() * sizeof(Word));
    if (guess_order && !holds_heights(words))
        throw Error(fmt::format(
            "'{}' holds no number that can be a height in metres, in either byte order: it must hold {}",
            path.string(), sizeof(Word) == 2 ? "16-bit integers" : "32-bit floats"));
    if (guess_order) {
        layout.big_endian = is_big_endian(words, layout.nx);
        notes.push_back(fmt::format("byte order guessed as {} from the heights: --raw sets it",
                                    layout.big_endian ? "big" : "little"));
    }
    std::vector<float> heights(words.size());
    for (int row = 0; row < layout.ny; ++row) {
        const int from = layout.south_first ? layout.ny - 1 - row : row;
        for (int column = 0; column < layout.nx; ++column) {
            const Word word = words[static_cast<std::size_t>(from) * layout.nx + column];
            heights[static_cast<std::size_t>(row) * layout.nx + column] =
                value_of(layout.big_endian ? swapped(word) : word);
        }
    }
    return heights;
}

int square_side(std::size_t samples) {
    const auto side = static_cast<std::size_t>(std::llround(std::sqrt(static_cast<double>(samples))));
    return side * side == samples ? static_cast<int>(side) : 0;
}

}  // namespace

RawLayout parse_raw_layout(const std::string& text) {
    RawLayout layout;
    const char* end = text.data() + text.size();
    auto next = std::from_chars(text.data(), end, layout.nx);
    if (next.ec == std::errc() && next.ptr != end && *next.ptr == 'x')
        next = std::from_chars(next.ptr + 1, end, layout.ny);
    std::string rest = next.ec == std::errc() ? std::string(next.ptr, end) : "?";
    for (const auto& [word, flag] :
         {std::pair{",big", &layout.big_endian}, std::pair{",bottom", &layout.south_first}}) {
        const auto at = rest.find(word);
        if (at == std::string::npos) continue;
        *flag = true;
        rest.erase(at, std::strlen(word));
    }
    if (!rest.empty() || layout.nx <= 0 || layout.ny <= 0)
        throw Error(fmt::format(
            "--raw '{}' cannot be read, write it as NXxNY with ',big' and ',bottom' where they apply", text));
    return layout;
}

Heightmap read_raw(const fs::path& path, const ImportSettings& settings) {
    const auto length = static_cast<std::size_t>(fs::file_size(path));
    if (length > 4ULL * max_samples * max_samples)
        throw Error(fmt::format("'{}' is longer than {} x {} samples, the most that Talus takes",
                                path.string(), max_samples, max_samples));
    const std::string ending = ending_of(path);
    Heightmap heightmap;
    const std::optional<Sidecar> sidecar = read_sidecar(path, heightmap.notes);
    RawLayout layout;
    std::size_t bytes = ending == ".r32" ? 4 : 2;
    if (settings.raw || (sidecar && sidecar->raw)) {
        layout = settings.raw ? *settings.raw : *sidecar->raw;
        check_file_size(path, layout.nx, layout.ny);
        const std::size_t samples = static_cast<std::size_t>(layout.nx) * layout.ny;
        if (ending == ".raw") bytes = length == 4 * samples ? 4 : 2;
        if (samples * bytes != length)
            throw Error(fmt::format("'{}' has {} bytes where {} x {} samples of {} bytes make {}",
                                    path.string(), length, layout.nx, layout.ny, bytes, samples * bytes));
    } else {
        if (ending == ".raw" && (length % 2 != 0 || square_side(length / 2) == 0)) bytes = 4;
        layout.nx = layout.ny = length % bytes == 0 ? square_side(length / bytes) : 0;
        if (layout.nx == 0)
            throw Error(
                fmt::format("'{}' has {} bytes, no square of {}-byte samples: give its size with --raw NXxNY",
                            path.string(), length, bytes));
        check_file_size(path, layout.nx, layout.ny);
        heightmap.notes.push_back(fmt::format(
            "size guessed from the file's length: {} x {} samples, north row first: --raw sets it", layout.nx,
            layout.ny));
    }
    heightmap.grid = {layout.nx, layout.ny, 1, 1};
    heightmap.kind = bytes == 2 ? "raw, 16-bit integer" : "raw, 32-bit float";
    const std::string content = read_text(path);
    const bool guess_order = !settings.raw && !(sidecar && sidecar->raw);
    heightmap.heights = bytes == 2
                            ? decode<std::uint16_t>(path, content, layout, guess_order, heightmap.notes)
                            : decode<std::uint32_t>(path, content, layout, guess_order, heightmap.notes);
    if (sidecar && sidecar->dx && sidecar->dy) {
        heightmap.grid.dx = *sidecar->dx;
        heightmap.grid.dy = *sidecar->dy;
        heightmap.georeference = sidecar->georeference;
    } else if (!settings.spacing_m) {
        heightmap.notes.push_back("the file says no spacing, 1 m a sample was taken: --spacing sets it");
    }
    if (settings.spacing_m) heightmap.grid.dx = heightmap.grid.dy = *settings.spacing_m;
    if (bytes == 2)
        scale_integers(heightmap, 65535, sidecar ? sidecar->range : std::nullopt, settings);
    else
        check_finite(path, heightmap), scale_floats(heightmap, settings);
    return heightmap;
}

void write_raw(const fs::path& path, const Heightmap& heightmap, std::optional<Range> range) {
    if (ending_of(path) == ".r32") {
        write_atomically(path, std::as_bytes(std::span(heightmap.heights)));
        return write_sidecar(path, heightmap, "float32", std::nullopt);
    }
    const Range used = range_for(heightmap, range);
    const std::vector<std::uint16_t> values = quantise(heightmap, used);
    write_atomically(path, std::as_bytes(std::span(values)));
    write_sidecar(path, heightmap, "uint16", used);
}

}  // namespace talus::io
