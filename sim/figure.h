#pragma once
#include <string>

namespace talus {

/// A number as people write it: without an exponent from 0.0001 to 10^15, and no -0.
std::string figure(double value, int digits);

}  // namespace talus
