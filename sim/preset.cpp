#include "sim/preset.h"

#include <fmt/format.h>

#include <toml++/toml.h>
#include <fstream>
#include <iterator>

#include "sim/error.h"
#include "sim/gpu/embedded_text.h"

namespace talus {
namespace {

toml::table parse(const std::string& text, const std::string& source) {
    try {
        return toml::parse(text, source);
    } catch (const toml::parse_error& error) {
        throw Error(fmt::format("{}: line {} is not TOML: {}", source, error.source().begin.line,
                                error.description()));
    }
}

// Sets what a table holds; names of tables within it are parts of the parameters' names.
void set_from(const toml::table& table, const std::string& prefix, Parameters& parameters) {
    for (const auto& [key, value] : table) {
        const std::string full = fmt::format("{}.{}", prefix, key.str());
        if (value.is_table())
            set_from(*value.as_table(), full, parameters);
        else if (const auto on = value.value_exact<bool>())
            parameters.set(full, *on);
        else if (const auto text = value.value_exact<std::string>())
            parameters.set(full, *text);
        else if (const auto real = value.value<double>())
            parameters.set(full, *real);
        else
            throw Error(fmt::format("{} must be a number, a text or true or false", full));
    }
}

Preset read(const std::string& name, const std::string& text, const std::string& source) {
    const toml::table table = parse(text, source);
    return {name, table["title"].value_or(name), table["description"].value_or(std::string()), text};
}

}  // namespace

std::vector<Preset> built_in_presets() {
    std::vector<Preset> presets;
    for (const auto& [file, text] : embedded_presets()) {
        if (!file.ends_with(".toml")) continue;
        const std::string name = file.substr(0, file.rfind('.'));
        presets.push_back(read(name, std::string(text), "preset " + name));
    }
    return presets;
}

Preset find_preset(const std::string& name_or_path) {
    if (name_or_path.ends_with(".toml")) {
        if (std::filesystem::is_directory(name_or_path))
            throw Error(fmt::format("preset '{}' is a folder, a TOML file is needed", name_or_path));
        std::ifstream file(name_or_path, std::ios::binary);
        if (!file) throw Error(fmt::format("preset '{}' cannot be read, no such file", name_or_path));
        const std::string text{std::istreambuf_iterator<char>(file), {}};
        return read(std::filesystem::path(name_or_path).stem().string(), text, name_or_path);
    }
    std::string names;
    for (Preset& preset : built_in_presets()) {
        if (preset.name == name_or_path) return preset;
        names += fmt::format("{}{}", names.empty() ? "" : ", ", preset.name);
    }
    throw Error(fmt::format("there is no preset '{}', use one of: {}, or a file ending in .toml",
                            name_or_path, names));
}

void apply_preset(const Preset& preset, Parameters& parameters) {
    from_toml(preset.text, "preset " + preset.name, parameters);
}

std::string to_toml(const Parameters& parameters) {
    std::string text;
    std::string section;
    for (const Parameter& p : parameters.declared()) {
        // An unset parameter is not written, so that it still follows another one when read again.
        if (!parameters.is_given(p.name)) continue;
        const Value& value = parameters.value(p.name);
        const auto dot = p.name.find('.');
        if (p.name.substr(0, dot) != section) {
            section = p.name.substr(0, dot);
            text += fmt::format("[{}]\n", section);
        }
        std::string written = to_text(value);
        if (std::holds_alternative<std::string>(value)) written = fmt::format("\"{}\"", written);
        if (std::holds_alternative<double>(value) && written.find_first_of(".einf") == std::string::npos)
            written += ".0";
        text += fmt::format("{} = {}\n", p.name.substr(dot + 1), written);
    }
    return text;
}

void from_toml(const std::string& text, const std::string& source, Parameters& parameters) {
    const toml::table table = parse(text, source);
    Parameters changed = parameters;
    for (const auto& [section, node] : table) {
        const std::string_view name = section.str();
        if (!node.is_table()) {
            if ((name == "title" || name == "description") && node.is_string()) continue;
            if (name == "title" || name == "description")
                throw Error(fmt::format("{}: {} must be a text in quotes", source, name));
            throw Error(
                fmt::format("{}: unknown key '{}', only title, description and [sections] stand at the top",
                            source, name));
        }
        try {
            set_from(*node.as_table(), std::string(name), changed);
        } catch (const Error& error) {
            throw Error(fmt::format("{}: {}", source, error.what()));
        }
    }
    parameters = changed;
}

}  // namespace talus
