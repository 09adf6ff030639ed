#include "sim/preset.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <toml++/toml.h>
#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <utility>

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

double number_in(const toml::table& table, const char* key, std::optional<double> otherwise = std::nullopt) {
    const toml::node* node = table.get(key);
    const auto value = node ? node->value<double>() : otherwise;
    if (!value) throw Error(fmt::format("{} must be there, as a number", key));
    return *value;
}

glm::dvec2 place_in(const toml::table& table, const char* key) {
    const toml::array* pair = table[key].as_array();
    if (pair && pair->size() == 2) {
        const auto x = (*pair)[0].value<double>();
        const auto y = (*pair)[1].value<double>();
        if (x && y) return {*x, *y};
    }
    throw Error(fmt::format("{} must be two numbers, east and north, m", key));
}

void refuse_other_keys(const toml::table& table, const std::vector<std::string_view>& known) {
    for (const auto& [key, value] : table)
        if (std::find(known.begin(), known.end(), key.str()) == known.end())
            throw Error(
                fmt::format("unknown key '{}', it must be one of: {}", key.str(), fmt::join(known, ", ")));
}

Event event_from(const toml::table& table) {
    refuse_other_keys(table, {"at_s", "set", "breach"});
    Event event;
    event.at_s = number_in(table, "at_s");
    const auto set = table["set"].value_exact<std::string>();
    const toml::table* told = table["breach"].as_table();
    if (set.has_value() == (told != nullptr))
        throw Error("it must have either set, \"section.name=value\", or a table breach");
    if (set) {
        event.assignment = *set;
        return event;
    }
    refuse_other_keys(*told, {"from_m", "to_m", "width_m", "crest_m", "bottom_m", "side_slope", "over_s"});
    event.breach = Breach{.from_m = place_in(*told, "from_m"),
                          .to_m = place_in(*told, "to_m"),
                          .width_m = number_in(*told, "width_m"),
                          .crest_m = number_in(*told, "crest_m"),
                          .bottom_m = number_in(*told, "bottom_m"),
                          .side_slope = number_in(*told, "side_slope", 1),
                          .over_s = number_in(*told, "over_s", 0)};
    return event;
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

bool is_preset_file(const std::string& name_or_path) {
    std::string ending = std::filesystem::path(name_or_path).extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
    return ending == ".toml";
}

Preset find_preset(const std::string& name_or_path) {
    if (is_preset_file(name_or_path)) {
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

std::vector<Event> events_of(const Preset& preset) {
    const std::string source = "preset " + preset.name;
    const toml::table table = parse(preset.text, source);
    std::vector<Event> events;
    const toml::array* told = table["event"].as_array();
    if (!told) return events;
    for (const toml::node& node : *told) try {
            events.push_back(event_from(*node.as_table()));
        } catch (const Error& error) {
            throw Error(
                fmt::format("{}: event {} cannot be read: {}", source, events.size() + 1, error.what()));
        }
    return events;
}

namespace {

// A text in quotes, as TOML has it.
std::string toml_text(const std::string& text) {
    std::string written = "\"";
    for (const char letter : text) {
        const auto code = static_cast<unsigned char>(letter);
        if (letter == '"' || letter == '\\')
            written += fmt::format("\\{}", letter);
        else if (code < 0x20 || code == 0x7F)
            written += fmt::format("\\u{:04X}", code);
        else
            written += letter;
    }
    return written + "\"";
}

// With the dot that makes it no whole number, where TOML cares.
std::string toml_number(double value) {
    const std::string written = fmt::format("{}", value);
    return written.find_first_of(".einf") == std::string::npos ? written + ".0" : written;
}

std::string event_toml(const Event& event) {
    std::string text = fmt::format("\n[[event]]\nat_s = {}\n", toml_number(event.at_s));
    if (!event.breach) return text + fmt::format("set = {}\n", toml_text(event.assignment));
    const Breach& breach = *event.breach;
    text +=
        fmt::format("breach.from_m = [{}, {}]\n", toml_number(breach.from_m.x), toml_number(breach.from_m.y));
    text += fmt::format("breach.to_m = [{}, {}]\n", toml_number(breach.to_m.x), toml_number(breach.to_m.y));
    for (const auto& [name, value] :
         {std::pair("width_m", breach.width_m), std::pair("crest_m", breach.crest_m),
          std::pair("bottom_m", breach.bottom_m), std::pair("side_slope", breach.side_slope),
          std::pair("over_s", breach.over_s)})
        text += fmt::format("breach.{} = {}\n", name, toml_number(value));
    return text;
}

}  // namespace

std::string preset_text(const std::string& title, const std::string& sections,
                        const std::vector<Event>& events) {
    std::string text = fmt::format("title = {}\n\n{}", toml_text(title), sections);
    for (const Event& event : events) text += event_toml(event);
    return text;
}

std::string to_toml(const Parameters& parameters) {
    // A section stands once, wherever its parameters are declared.
    std::vector<std::pair<std::string, std::string>> sections;
    for (const Parameter& p : parameters.declared()) {
        // An unset parameter is not written, so that it still follows another one when read again.
        if (!parameters.is_given(p.name)) continue;
        const Value& value = parameters.value(p.name);
        const auto dot = p.name.find('.');
        const std::string name = p.name.substr(0, dot);
        auto section = std::find_if(sections.begin(), sections.end(),
                                    [&](const auto& one) { return one.first == name; });
        if (section == sections.end()) section = sections.insert(section, {name, ""});
        std::string written = to_text(value);
        if (std::holds_alternative<std::string>(value)) written = fmt::format("\"{}\"", written);
        if (const double* number = std::get_if<double>(&value)) written = toml_number(*number);
        section->second += fmt::format("{} = {}\n", p.name.substr(dot + 1), written);
    }
    std::string text;
    for (const auto& [name, lines] : sections) text += fmt::format("[{}]\n{}", name, lines);
    return text;
}

void from_toml(const std::string& text, const std::string& source, Parameters& parameters) {
    const toml::table table = parse(text, source);
    Parameters changed = parameters;
    for (const auto& [section, node] : table) {
        const std::string_view name = section.str();
        if (name == "event" && node.is_array_of_tables()) continue;
        if (!node.is_table()) {
            if ((name == "title" || name == "description") && node.is_string()) continue;
            if (name == "title" || name == "description")
                throw Error(fmt::format("{}: {} must be a text in quotes", source, name));
            throw Error(fmt::format(
                "{}: unknown key '{}', only title, description, [sections] and [[event]] stand at the top",
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
