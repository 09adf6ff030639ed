#include "app/core/stamp_folder.h"

#include <algorithm>

#include "app/core/folder_listing.h"
#include "app/core/user_folders.h"
#include "app/core/wall_clock.h"
#include "sim/io/heightmap_formats.h"

namespace talus::app {

std::filesystem::path StampFolder::path() {
    return config_folder() / "stamps";
}

void StampFolder::follow() {
    constexpr double often_enough_s = 2;
    if (wall_clock_s() - looked_at_s_ < often_enough_s) return;
    looked_at_s_ = wall_clock_s();
    // So that it is found where it is named.
    std::error_code ignored;
    std::filesystem::create_directories(path(), ignored);
    std::vector<FolderEntry> entries = entries_of(path().string());
    sort_entries(entries, ListedBy::name, false);
    const std::vector<std::string> endings = io::readable_endings();
    files_.clear();
    for (const FolderEntry& entry : entries)
        if (!entry.is_folder && std::find(endings.begin(), endings.end(), entry.ending) != endings.end())
            files_.push_back(entry.name);
}

}  // namespace talus::app
