#pragma once
#include <functional>
#include <map>
#include <string>
#include <string_view>

namespace talus {

/// The text files below shaders/, by path, as they were when the program was built.
const std::map<std::string, std::string_view, std::less<>>& embedded_shaders();

/// The files below presets/, by path, as they were when the program was built: scenes as text, and their
/// pictures as PNG.
const std::map<std::string, std::string_view, std::less<>>& embedded_presets();

}  // namespace talus
