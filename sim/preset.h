#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "sim/parameters.h"
#include "sim/terrain/terrain_state.h"

namespace talus {

/// A scene as the app offers it: TOML with title, description and sections of parameters.
struct Preset {
    std::string name;
    std::string title;
    std::string description;
    std::string text;
};

/// The built-in presets by name.
std::vector<Preset> built_in_presets();

/// Whether it is the path of a preset's file rather than a name: it ends in .toml, however that is written.
bool is_preset_file(const std::string& name_or_path);

/// A built-in preset by name, or one from a path that ends in .toml. Throws talus::Error when there is none.
Preset find_preset(const std::string& name_or_path);

/// Sets what the preset sets. Throws talus::Error that names the preset and the key when a key is unknown, or
/// a value of the wrong type or out of range; the parameters are as they were then.
void apply_preset(const Preset& preset, Parameters& parameters);

/// The preset's events, tables [[event]] with at_s, and set ("section.name=value") or breach. Throws
/// talus::Error that names the preset where one cannot be read.
std::vector<Event> events_of(const Preset& preset);

/// A preset's file: its title, its sections of parameters (to_toml()), its events.
std::string preset_text(const std::string& title, const std::string& sections,
                        const std::vector<Event>& events);

/// The parameters that were given, as TOML; and back.
std::string to_toml(const Parameters& parameters);
void from_toml(const std::string& text, const std::string& source, Parameters& parameters);

}  // namespace talus
