#pragma once
#include <chrono>
#include <cstdint>
#include <string>
#include <vector>

namespace talus::app {

/// A file or folder, as dialogs list it.
struct FolderEntry {
    std::string name;
    std::string ending{};  ///< as io::ending_of() has it
    bool is_folder = false;
    std::uintmax_t bytes = 0;                         ///< of a file
    std::chrono::system_clock::time_point changed{};  ///< the epoch: it is not known
};

/// By what a listing is sorted; folders stand first anyway.
enum class ListedBy { name, size, changed };

/// What is in a folder, but for hidden files; nothing where it cannot be read.
std::vector<FolderEntry> entries_of(const std::string& folder);
/// Names: a number within them counts as one, "depth_9" stands before "depth_10".
void sort_entries(std::vector<FolderEntry>& entries, ListedBy by, bool descending);

/// "17 kB", "2.4 MB": in powers of a thousand.
std::string size_text(std::uintmax_t bytes);
/// Local time, to the minute.
std::string time_text(std::chrono::system_clock::time_point time);

}  // namespace talus::app
