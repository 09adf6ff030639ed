#pragma once
#include <cstdint>
#include <string>
#include <variant>

#include "sim/parameters.h"
#include "sim/passes/brush.h"

namespace talus {

/// A number of whole ticks.
struct Ticks {
    std::int64_t count = 1;
    bool operator==(const Ticks&) const = default;
};

/// A change of one simulation parameter.
struct SetParameter {
    std::string name;
    Value value;
    bool operator==(const SetParameter&) const = default;
};

/// One recorded act. Replaying a list of them gives the same terrain.
using Operation = std::variant<Ticks, Dab, SetParameter>;

}  // namespace talus
