#include "app/core/recent_files.h"

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "app/core/user_folders.h"
#include "sim/io/atomic_file.h"

namespace talus::app {
namespace {

namespace fs = std::filesystem;
constexpr std::size_t most_recent = 12;

fs::path list_file() {
    return state_folder() / "recent";
}

std::vector<std::string> listed() {
    std::vector<std::string> files;
    std::ifstream list(list_file());
    for (std::string line; std::getline(list, line) && files.size() < most_recent;)
        if (!line.empty()) files.push_back(line);
    return files;
}

}  // namespace

std::vector<std::string> recent_files() {
    std::vector<std::string> files = listed();
    std::erase_if(files, [](const std::string& file) {
        std::error_code failed;
        return !fs::is_regular_file(file, failed);
    });
    return files;
}

void remember_file(const std::string& path) {
    std::error_code failed;
    const std::string absolute = fs::absolute(path, failed).lexically_normal().string();
    std::vector<std::string> files = listed();
    std::erase(files, absolute);
    files.insert(files.begin(), absolute);
    if (files.size() > most_recent) files.resize(most_recent);
    std::string text;
    for (const std::string& file : files) text += file + '\n';
    try {
        fs::create_directories(state_folder());
        io::write_atomically(list_file(), text);
    } catch (const std::exception&) {
        // The next start has an older list.
    }
}

}  // namespace talus::app
