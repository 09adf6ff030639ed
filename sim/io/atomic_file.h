#pragma once
#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace talus::io {

/// Writes a whole file so that the path holds either what was there or all of the new content, also across a
/// crash: temporary file beside it, fsync, rename, fsync of the folder. Throws talus::Error naming the path
/// and the reason; nothing is left behind then.
void write_atomically(const std::filesystem::path& path, std::span<const std::byte> content);
void write_atomically(const std::filesystem::path& path, std::string_view content);

/// A whole file as text. Throws talus::Error when it cannot be read.
std::string read_text(const std::filesystem::path& path);

}  // namespace talus::io
