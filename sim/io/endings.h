#pragma once
#include <filesystem>
#include <string>

namespace talus::io {

/// The path's ending in lower case, with its dot; empty where it has none.
std::string ending_of(const std::filesystem::path& path);

/// Whether it ends as pictures, heightmaps or meshes do. "ridge.v2" does not: what stands behind its dot
/// belongs to the name.
bool has_known_ending(const std::filesystem::path& path);

/// The path with `ending` (with its dot) behind it, unless it has a known one or names no file ("", "a/",
/// "..").
std::filesystem::path with_ending(const std::filesystem::path& path, const std::string& ending);

/// The path with `ending` in place of a known one, or behind it.
std::filesystem::path with_other_ending(const std::filesystem::path& path, const std::string& ending);

}  // namespace talus::io
