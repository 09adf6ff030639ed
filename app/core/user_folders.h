#pragma once
#include <filesystem>

namespace talus::app {

/// Where a person's files of Talus lie (XDG Base Directory Specification 0.8): what can be made again, how
/// the window looked, and what must not be lost. Beneath the temporary folder where there is no home. They
/// need not exist yet.
std::filesystem::path cache_folder();
std::filesystem::path config_folder();
std::filesystem::path state_folder();

}  // namespace talus::app
