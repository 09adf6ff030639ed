#include "app/core/user_folders.h"

#include <cstdlib>

namespace talus::app {
namespace {

namespace fs = std::filesystem;

fs::path folder(const char* variable, const char* below_home) {
    const char* given = std::getenv(variable);
    const char* home = std::getenv("HOME");
    // The specification wants relative paths ignored.
    if (given && *given == '/') return fs::path(given) / "talus";
    if (home && *home) return fs::path(home) / below_home / "talus";
    return fs::temp_directory_path() / "talus";
}

}  // namespace

fs::path cache_folder() {
    return folder("XDG_CACHE_HOME", ".cache");
}
fs::path config_folder() {
    return folder("XDG_CONFIG_HOME", ".config");
}
fs::path state_folder() {
    return folder("XDG_STATE_HOME", ".local/state");
}

}  // namespace talus::app
