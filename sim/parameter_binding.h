#pragma once
#include <functional>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "sim/parameters.h"

namespace talus {

/// A declared parameter, and how its value gets into the settings that it is one of. A parameter of a pass is
/// a line of the table of its settings: panels, presets, --set, help, journal and the pass follow from it.
template <typename Settings>
struct BoundParameter {
    std::optional<Parameter> declared;  ///< none: another table declares it
    std::function<void(const Parameters&, Settings&)> put;
};

template <typename Settings, typename Member>
std::function<void(const Parameters&, Settings&)> put_into(Member Settings::*member, std::string name,
                                                           double unit) {
    return [=](const Parameters& parameters, Settings& settings) {
        if constexpr (std::is_same_v<Member, bool>)
            settings.*member = parameters.declaration(name).choices.empty()
                                   ? parameters.toggle(name)
                                   : parameters.template choice_as<int>(name) != 0;
        else if constexpr (std::is_enum_v<Member>)
            settings.*member = parameters.template choice_as<Member>(name);
        else if constexpr (std::is_same_v<Member, int>)
            settings.*member = parameters.whole(name);
        else
            settings.*member = parameters.number(name) * unit;
    };
}

/// Puts the value into a member. A number is multiplied by `unit`, the parameter's unit in units of the
/// member. A choice becomes its index: an enum, or a switch if there are two choices.
template <typename Settings, typename Member>
BoundParameter<Settings> bound(Parameter declared, Member Settings::*member, double unit = 1) {
    std::string name = declared.name;
    return {std::move(declared), put_into(member, std::move(name), unit)};
}
/// The same of a parameter that another table declares.
template <typename Settings, typename Member>
BoundParameter<Settings> shared(std::string name, Member Settings::*member, double unit = 1) {
    return {std::nullopt, put_into(member, std::move(name), unit)};
}
/// A parameter that no member holds: who needs it reads it by its name.
template <typename Settings>
BoundParameter<Settings> unbound(Parameter declared) {
    return {std::move(declared), [](const Parameters&, Settings&) {}};
}

/// The settings that the parameters of its table say.
template <typename Settings>
Settings bound_settings(const std::vector<BoundParameter<Settings>>& table, const Parameters& parameters) {
    Settings settings;
    for (const BoundParameter<Settings>& one : table) one.put(parameters, settings);
    return settings;
}

/// The parameters that tables declare, one table behind the other.
template <typename... Settings>
std::vector<Parameter> declared(const std::vector<BoundParameter<Settings>>&... tables) {
    std::vector<Parameter> all;
    const auto add = [&](const auto& table) {
        for (const auto& one : table)
            if (one.declared) all.push_back(*one.declared);
    };
    (add(tables), ...);
    return all;
}

}  // namespace talus
