#include "app/core/calibration.h"

#include <toml++/toml.h>
#include <filesystem>
#include <map>
#include <sstream>
#include <string>

#include "app/core/user_folders.h"
#include "render/calibration.h"
#include "sim/io/atomic_file.h"

namespace talus::app {
namespace {

namespace fs = std::filesystem;

toml::table read_cache(const fs::path& file) {
    try {
        return toml::parse_file(file.string());
    } catch (const toml::parse_error&) {
        return {};  // not there yet, or not ours: measured anew
    }
}

}  // namespace

double patch_pixels(const gpu::Device& device) {
    static std::map<std::string, double> known;
    const std::string name = device.renderer + ", " + device.version;
    if (const auto found = known.find(name); found != known.end()) return found->second;
    const fs::path file = cache_folder() / "calibration.toml";
    toml::table cache = read_cache(file);
    if (const auto value = cache[name]["patch_pixels"].value<double>();
        value && *value >= 4 && *value <= 1024) {
        return known[name] = *value;
    }
    const double measured = render::measure_patch_pixels(device.software);
    cache.insert_or_assign(name, toml::table{{"patch_pixels", measured}});
    try {
        fs::create_directories(file.parent_path());
        std::ostringstream text;
        text << cache << "\n";
        io::write_atomically(file.string(), text.str());
    } catch (const std::exception&) {
        // A cache that cannot be written costs the next start another measurement.
    }
    return known[name] = measured;
}

}  // namespace talus::app
