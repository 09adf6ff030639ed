#pragma once
#include <array>
#include <string>

namespace talus::claims {

/// What this device makes of `precise` sums, products, quotients and square roots in float, of a million
/// random operands whose results are normal numbers. OpenGL asks for exact rounding of neither ÷ (2.5 units
/// of the last digit) nor √ (as 1/inversesqrt: GLSL 4.50, 4.7.1). A pass can give its float twin's bits only
/// where all round exactly (law 4).
struct Arithmetic {
    struct Operation {
        std::string name;      ///< "+", "×", "÷", "√", and "× +": a product and a sum in one expression
        int differing = 0;     ///< results that are not what IEEE 754 rounds to
        double worst_ulp = 0;  ///< their largest distance from the exact result, in units of its last digit
    };
    int samples = 0;
    std::array<Operation, 5> operations = {{{"+"}, {"×"}, {"÷"}, {"√"}, {"× +"}}};
    bool rounds_as_ieee() const;
    /// By its name; throws talus::Error for any other.
    const Operation& of(const std::string& name) const;
};

/// Asks the device of the current context.
Arithmetic arithmetic_of_device();

/// One line for people.
std::string describe(const Arithmetic& arithmetic);

}  // namespace talus::claims
