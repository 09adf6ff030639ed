#include "sim/parameters.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cassert>
#include <charconv>
#include <cmath>

#include "sim/error.h"
#include "sim/figure.h"

namespace talus {

Parameter number(std::string name, double preset, double low, double high, std::string unit,
                 std::string help) {
    return {std::move(name), preset, low, high, std::move(unit), std::move(help), {}};
}
Parameter whole(std::string name, int preset, int low, int high, std::string unit, std::string help) {
    return {std::move(name), preset, static_cast<double>(low), static_cast<double>(high), std::move(unit),
            std::move(help), {}};
}
Parameter toggle(std::string name, bool preset, std::string help) {
    return {std::move(name), preset, 0, 1, "", std::move(help), {}};
}
Parameter choice(std::string name, std::string preset, std::vector<std::string> choices, std::string help) {
    return {std::move(name), std::move(preset), 0, 0, "", std::move(help), std::move(choices)};
}

Parameter Parameter::once(std::string before) && {
    old_name = std::move(before);
    return std::move(*this);
}
Parameter Parameter::following(std::string other) && {
    follows = std::move(other);
    return std::move(*this);
}
Parameter Parameter::setting_off(SetsOff what) && {
    sets_off = what;
    return std::move(*this);
}

Parameter Parameter::following_tables(Driven how) && {
    driven = how;
    return std::move(*this);
}

Parameter Parameter::of_this_machine() && {
    of_machine = true;
    return std::move(*this);
}

Parameter Parameter::labelled(std::string words) && {
    label = std::move(words);
    return std::move(*this);
}

Parameter Parameter::choices_labelled(std::vector<std::string> words) && {
    assert(words.size() == choices.size());
    choice_labels = std::move(words);
    return std::move(*this);
}

std::string label_of_name(std::string name) {
    for (char& letter : name)
        if (letter == '_' || letter == '.') letter = ' ';
    if (!name.empty() && name[0] >= 'a' && name[0] <= 'z') name[0] = static_cast<char>(name[0] - 'a' + 'A');
    return name;
}

std::string label_of(const Parameter& p) {
    if (!p.label.empty()) return p.label;
    std::string name = p.name.substr(p.name.find('.') + 1);
    // The unit stands behind the value, so it need not stand in the label too.
    const std::string unit = unit_in_name(p.unit);
    if (!unit.empty() && name.ends_with(unit)) name.resize(name.size() - unit.size());
    return label_of_name(std::move(name));
}

std::string label_of_choice(const Parameter& p, const std::string& chosen) {
    const auto found = std::find(p.choices.begin(), p.choices.end(), chosen);
    const auto place = static_cast<std::size_t>(found - p.choices.begin());
    return place < p.choice_labels.size() ? p.choice_labels[place] : label_of_name(chosen);
}

std::string value_text(const Parameter& p, const Value& value) {
    if (const auto* on = std::get_if<bool>(&value)) return *on ? "on" : "off";
    if (const auto* name = std::get_if<std::string>(&value)) return label_of_choice(p, *name);
    const auto* count = std::get_if<int>(&value);
    const std::string number = figure(count ? *count : std::get<double>(value), 6);
    return p.unit.empty() ? number : number + " " + p.unit;
}

std::string unit_in_name(const std::string& unit) {
    static const std::map<std::string, std::string> names = {
        {"m", "_m"},           {"mm", "_mm"},         {"s", "_s"},       {"m/s", "_m_per_s"},
        {"mm/s", "_mm_per_s"}, {"mm/h", "_mm_per_h"}, {"1/s", "_per_s"}, {"m/s²", "_m_per_s2"},
        {"m²/s", "_m2_per_s"}, {"m³/s", "_m3_per_s"}, {"Pa", "_pa"},     {"°", "_deg"},
        {"px", "_px"},         {"px²", "_px2"},       {"MiB", "_mib"},   {"%", "_percent"},
        {"m/km", "_m_per_km"},
    };
    const auto found = names.find(unit);
    return found == names.end() ? "" : found->second;
}

std::string to_text(const Value& value) {
    if (const auto* on = std::get_if<bool>(&value)) return *on ? "true" : "false";
    if (const auto* count = std::get_if<int>(&value)) return std::to_string(*count);
    if (const auto* real = std::get_if<double>(&value)) return fmt::format("{}", *real);
    return std::get<std::string>(value);
}

Parameters::Parameters(std::vector<Parameter> declared)
    : declared_(std::make_shared<std::vector<Parameter>>(std::move(declared))) {
    for (const Parameter& parameter : *declared_) values_.emplace(parameter.name, parameter.preset);
}

const Parameter& Parameters::declaration(std::string_view name) const {
    const auto found = std::find_if(declared_->begin(), declared_->end(),
                                    [&](const Parameter& p) { return p.name == name || p.old_name == name; });
    if (found == declared_->end())
        throw Error(fmt::format("there is no parameter '{}', 'talus parameters' lists them", name));
    return *found;
}

const Value& Parameters::value(std::string_view name) const {
    const auto found = values_.find(name);
    return found != values_.end() ? found->second : values_.find(declaration(name).name)->second;
}

int Parameters::place_of_choice(std::string_view name) const {
    const std::vector<std::string>& choices = declaration(name).choices;
    return static_cast<int>(std::find(choices.begin(), choices.end(), choice(name)) - choices.begin());
}

bool Parameters::is_given(std::string_view name) const {
    return given_.contains(declaration(name).name);
}

Value Parameters::checked(const Parameter& p, const Value& value) const {
    Value v = value;
    // A whole number will do where a number is wanted, and the other way round where nothing is lost.
    if (std::holds_alternative<double>(p.preset) && std::holds_alternative<int>(v))
        v = static_cast<double>(std::get<int>(v));
    if (std::holds_alternative<int>(p.preset) && std::holds_alternative<double>(v)) {
        const double real = std::get<double>(v);
        if (real == std::floor(real) && std::abs(real) < 2e9) v = static_cast<int>(real);
    }
    if (v.index() != p.preset.index()) {
        const char* wanted = std::holds_alternative<bool>(p.preset)     ? "true or false"
                             : std::holds_alternative<int>(p.preset)    ? "a whole number"
                             : std::holds_alternative<double>(p.preset) ? "a number"
                                                                        : "a name in quotes";
        throw Error(fmt::format("{} cannot be '{}', it must be {}", p.name, to_text(value), wanted));
    }
    if (const auto* text = std::get_if<std::string>(&v)) {
        if (std::find(p.choices.begin(), p.choices.end(), *text) == p.choices.end())
            throw Error(fmt::format("{} cannot be '{}', it must be one of: {}", p.name, *text,
                                    fmt::join(p.choices, ", ")));
    } else if (!std::holds_alternative<bool>(v)) {
        const double real = std::holds_alternative<int>(v) ? std::get<int>(v) : std::get<double>(v);
        if (!(real >= p.low && real <= p.high))
            throw Error(fmt::format("{} = {} is out of range, it must be {} to {}{}{}", p.name,
                                    to_text(value), p.low, p.high, p.unit.empty() ? "" : " ", p.unit));
    }
    return v;
}

void Parameters::set(std::string_view name, const Value& value) {
    const Parameter& p = declaration(name);
    const Value v = checked(p, value);
    values_.find(p.name)->second = v;
    given_[p.name] = true;
    pass_on(p);
}

void Parameters::pass_on(const Parameter& followed) {
    for (const Parameter& p : *declared_)
        if (p.follows == followed.name) suggest(p.name, value(followed.name));
}

void Parameters::set_text(std::string_view name, const std::string& text) {
    const Parameter& p = declaration(name);
    if (std::holds_alternative<std::string>(p.preset)) return set(name, text);
    if (text == "true" || text == "false") return set(name, text == "true");
    double real = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), real);
    if (error != std::errc() || end != text.data() + text.size()) return set(name, Value(text));
    set(name, real);
}

void Parameters::set_assignment(const std::string& assignment) {
    const auto at = assignment.find('=');
    if (at == std::string::npos)
        throw Error(fmt::format("'{}' sets nothing, write it as section.name=value", assignment));
    set_text(assignment.substr(0, at), assignment.substr(at + 1));
}

void Parameters::suggest(std::string_view name, const Value& value) {
    const Parameter& p = declaration(name);
    if (is_given(p.name)) return;
    Value v = value;
    if (auto* real = std::get_if<double>(&v)) *real = std::clamp(*real, p.low, p.high);
    values_.find(p.name)->second = checked(p, v);
    pass_on(p);
}

void Parameters::reset(std::string_view name) {
    const Parameter& p = declaration(name);
    given_.erase(p.name);
    suggest(p.name, p.follows.empty() ? p.preset : value(p.follows));
}

}  // namespace talus
