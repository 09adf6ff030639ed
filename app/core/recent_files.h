#pragma once
#include <string>
#include <vector>

namespace talus::app {

/// Files that were opened or saved, the last one first; those that are gone are left out.
std::vector<std::string> recent_files();
/// Puts a file in front. A list that cannot be written is no error: it is a convenience.
void remember_file(const std::string& path);

}  // namespace talus::app
