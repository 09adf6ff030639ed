#pragma once
#include <map>
#include <string>

#include "sim/parameters.h"

namespace talus::render {

/// Values of the parameters that methods and views declare of their own, by name. Where one is missing, its
/// default holds.
using OwnNumbers = std::map<std::string, double>;

/// The value of one: of a choice, its place among them from 0.
double own_number(const OwnNumbers& numbers, const Parameter& parameter);

/// The same of a value that such a parameter may have.
double as_number(const Parameter& parameter, const Value& value);

}  // namespace talus::render
