#pragma once
#include "shaders/maths/twin.h"
#include "sim/passes/water_settings.h"

namespace talus {

/// What shaders are told of the exchange of solid; the twin takes the same numbers.
struct SedimentNumbers {
    TALUS_TWIN_NAMES(float)
#define NUMBER TALUS_MEMBER
#include "maths/sediment_numbers.glsl"
#undef NUMBER
};
SedimentNumbers sediment_numbers(const WaterSettings& water);

/// Metres of regolith that a metre of solid makes, as the shaders count it.
float bulking_of(double porosity);

}  // namespace talus
