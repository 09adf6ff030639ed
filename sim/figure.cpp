#include "sim/figure.h"

#include <fmt/format.h>

#include <cmath>

namespace talus {

std::string figure(double value, int digits) {
    const double size = std::abs(value);
    std::string text = fmt::format("{:.{}g}", value, digits);
    // Whether it is written with an exponent is decided after it was rounded: 999.9 becomes 1000.
    if (size >= 1 && size < 1e15 && text.find('e') != std::string::npos) text = fmt::format("{:.0f}", value);
    return text == "-0" ? "0" : text;
}

}  // namespace talus
