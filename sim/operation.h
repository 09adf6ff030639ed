#pragma once
#include <cstdint>
#include <string>
#include <variant>

#include "sim/parameters.h"
#include "sim/passes/brush.h"
#include "sim/terrain/terrain.h"

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

/// A spring is placed; at the sample of another one it takes its place, and with rate 0 there is none.
using PlaceSpring = Spring;

/// One recorded act. Replaying a list of them gives the same terrain.
using Operation = std::variant<Ticks, Dab, SetParameter, PlaceSpring>;

}  // namespace talus
