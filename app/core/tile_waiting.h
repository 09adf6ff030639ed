#pragma once
#include <cstddef>
#include <filesystem>
#include <functional>

namespace talus::app {

/// Calls `look` until no tile is on its way any more. look: takes what has come, and tells how many are.
/// Throws talus::Error naming the file where none comes for 20 s.
void wait_for_tiles(const std::filesystem::path& file, const std::function<std::size_t()>& look);

}  // namespace talus::app
