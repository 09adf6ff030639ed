#include "render/own_numbers.h"

#include <algorithm>

namespace talus::render {

double as_number(const Parameter& parameter, const Value& value) {
    if (const auto* chosen = std::get_if<std::string>(&value))
        return static_cast<double>(std::find(parameter.choices.begin(), parameter.choices.end(), *chosen) -
                                   parameter.choices.begin());
    if (const int* whole = std::get_if<int>(&value)) return *whole;
    return std::get<double>(value);
}

double own_number(const OwnNumbers& numbers, const Parameter& parameter) {
    const auto given = numbers.find(parameter.name);
    return given != numbers.end() ? given->second : as_number(parameter, parameter.preset);
}

}  // namespace talus::render
