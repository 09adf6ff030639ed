#include "sim/io/tile_sidecar.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "sim/error.h"
#include "sim/io/atomic_file.h"
#include "sim/terrain/state_hash.h"

namespace talus::io {
namespace {

namespace fs = std::filesystem;

// In front of the bounds; all numbers little-endian, as every machine is that Talus runs on. What a level's
// samples are, the fingerprint does not tell.
struct TileSidecarHead {
    std::array<char, 8> magic;
    std::uint64_t fingerprint;
    std::uint64_t levels_hash;
    std::uint64_t count;
    std::uint64_t bounds_hash;
};
constexpr std::array<char, 8> tile_sidecar_magic = {'t', 'a', 'l', 'u', 's', ' ', 'T', '1'};

std::uint64_t hash_of_levels(const TileTree& tree) {
    std::vector<std::int64_t> told = {tree.side()};
    for (const TileLevel& level : tree.levels())
        told.insert(told.end(), {level.samples.x, level.samples.y, level.tiles.x, level.tiles.y,
                                 static_cast<std::int64_t>(level.ratio.x * 65536),
                                 static_cast<std::int64_t>(level.ratio.y * 65536)});
    return bytes_hash(std::as_bytes(std::span(told)));
}

}  // namespace

fs::path tile_sidecar_path(const fs::path& path) {
    return path.string() + ".tiles";
}

void write_tile_sidecar(const TiledFile& file, const TileTree& tree, const std::vector<TileBounds>& bounds) {
    const auto bytes = std::as_bytes(std::span(bounds));
    const TileSidecarHead head = {tile_sidecar_magic, file.levels_fingerprint(), hash_of_levels(tree),
                                  bounds.size(), bytes_hash(bytes)};
    std::vector<std::byte> content(sizeof(head) + bytes.size());
    std::memcpy(content.data(), &head, sizeof(head));
    std::memcpy(content.data() + sizeof(head), bytes.data(), bytes.size());
    write_atomically(tile_sidecar_path(file.path()), std::span<const std::byte>(content));
}

std::optional<std::vector<TileBounds>> read_tile_sidecar(const TiledFile& file, const TileTree& tree) {
    const fs::path path = tile_sidecar_path(file.path());
    std::vector<TileBounds> bounds(tree.count());
    const std::size_t size = sizeof(TileSidecarHead) + bounds.size() * sizeof(TileBounds);
    std::error_code failed;
    if (!fs::is_regular_file(path, failed) || fs::file_size(path, failed) != size || failed)
        return std::nullopt;
    std::string content;
    try {
        content = read_text(path);
    } catch (const Error&) {
        return std::nullopt;
    }
    if (content.size() != size) return std::nullopt;
    TileSidecarHead head{};
    std::memcpy(&head, content.data(), sizeof(head));
    std::memcpy(bounds.data(), content.data() + sizeof(head), content.size() - sizeof(head));
    const bool ours = head.magic == tile_sidecar_magic && head.fingerprint == file.levels_fingerprint() &&
                      head.levels_hash == hash_of_levels(tree) && head.count == tree.count() &&
                      head.bounds_hash == bytes_hash(std::as_bytes(std::span(bounds)));
    const bool sound = std::all_of(bounds.begin(), bounds.end(), [](const TileBounds& one) {
        return std::isfinite(one.lowest_m) && std::isfinite(one.highest_m) && std::isfinite(one.error_m) &&
               one.lowest_m <= one.highest_m && one.error_m >= 0;
    });
    if (!ours || !sound) return std::nullopt;
    return bounds;
}

}  // namespace talus::io
