#include "sim/io/endings.h"

#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cctype>
#include <set>

#include "sim/io/heightmap_formats.h"
#include "sim/io/mesh_formats.h"

namespace talus::io {
namespace {

std::set<std::string> known_endings() {
    std::set<std::string> known;
    for (const auto& endings : {mesh_endings(), readable_endings()})
        known.insert(endings.begin(), endings.end());
    for (const auto& [format, endings] : OIIO::get_extension_map())
        for (const std::string& ending : endings) known.insert("." + ending);
    return known;
}

}  // namespace

std::string ending_of(const std::filesystem::path& path) {
    std::string ending = path.extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return ending;
}

bool has_known_ending(const std::filesystem::path& path) {
    static const std::set<std::string> known = known_endings();
    return known.contains(ending_of(path));
}

std::filesystem::path with_ending(const std::filesystem::path& path, const std::string& ending) {
    const std::filesystem::path name = path.filename();
    if (name.empty() || name == "." || name == ".." || has_known_ending(path)) return path;
    std::filesystem::path completed = path;
    // "ridge." becomes "ridge.exr".
    if (ending_of(path) == ".") completed.replace_extension();
    completed += ending;
    return completed;
}

std::filesystem::path with_other_ending(const std::filesystem::path& path, const std::string& ending) {
    std::filesystem::path name = path;
    if (has_known_ending(path)) name.replace_extension();
    return with_ending(name, ending);
}

}  // namespace talus::io
