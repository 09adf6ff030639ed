#include "app/claims/arithmetic.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <span>
#include <vector>

#include "sim/error.h"
#include "sim/gpu/program.h"
#include "sim/gpu/texture.h"

namespace talus::claims {

bool Arithmetic::rounds_as_ieee() const {
    return std::all_of(operations.begin(), operations.end(),
                       [](const Operation& operation) { return operation.differing == 0; });
}

const Arithmetic::Operation& Arithmetic::of(const std::string& name) const {
    for (const Operation& operation : operations)
        if (operation.name == name) return operation;
    throw Error(fmt::format("'{}' is no operation that a device was asked for", name));
}

Arithmetic arithmetic_of_device() {
    constexpr int side = 1024;
    std::vector<glm::vec4> operands;
    operands.reserve(static_cast<std::size_t>(side) * side);
    // No result is denormal, which a device may flush.
    std::mt19937 random(7);
    std::uniform_real_distribution<float> digits(1, 2);
    std::uniform_int_distribution<int> exponent(-12, 12);
    const auto number = [&] { return std::ldexp(digits(random), exponent(random)); };
    for (int i = 0; i < side * side; ++i) {
        const float a = number();
        const float b = i % 2 == 0 ? number() : -number();
        operands.emplace_back(a, b, number(), number());
    }
    gpu::Texture in("arithmetic operands", gpu::Format::rgba32f, side, side);
    gpu::Texture out("arithmetic results", gpu::Format::rgba32f, side, side);
    gpu::Texture chained("arithmetic results, chained", gpu::Format::rgba32f, side, side);
    in.write(in.whole(), std::as_bytes(std::span(operands)));
    gpu::Program program("sim/arithmetic.comp");
    program.bind_image("operands", in);
    program.bind_image("results", out);
    program.bind_image("chained", chained);
    program.dispatch(side / 64, side);
    gpu::barrier({gpu::Use::texture_transfer});
    const auto results = out.read_all<glm::vec4>();
    const auto both = chained.read_all<glm::vec4>();

    Arithmetic found;
    found.samples = side * side;
    for (std::size_t i = 0; i < operands.size(); ++i) {
        const glm::vec4& x = operands[i];
        const double a = x.x;
        const double b = x.y;
        const float product = x.x * x.y;  // -ffp-contract=off
        const std::array<float, 5> wanted = {x.x + x.y, product, x.x / x.y, std::sqrt(x.z), product + x.w};
        const std::array<double, 5> exact = {a + b, a * b, a / b, std::sqrt(static_cast<double>(x.z)),
                                             static_cast<double>(product) + x.w};
        const std::array<float, 5> seen = {results[i].x, results[i].y, results[i].z, results[i].w, both[i].x};
        for (std::size_t k = 0; k < wanted.size(); ++k) {
            if (std::bit_cast<std::uint32_t>(wanted[k]) == std::bit_cast<std::uint32_t>(seen[k])) continue;
            Arithmetic::Operation& operation = found.operations[k];
            ++operation.differing;
            const float size = std::abs(wanted[k]);
            const double ulp = std::nextafter(size, std::numeric_limits<float>::infinity()) - size;
            operation.worst_ulp = std::max(operation.worst_ulp, std::abs(seen[k] - exact[k]) / ulp);
        }
    }
    return found;
}

std::string describe(const Arithmetic& arithmetic) {
    if (arithmetic.rounds_as_ieee()) return "+ × ÷ √ round as IEEE 754 asks";
    std::string text = fmt::format("of {} results other than IEEE 754's:", arithmetic.samples);
    for (const Arithmetic::Operation& operation : arithmetic.operations)
        if (operation.differing > 0)
            text += fmt::format(" {} {} (at most {:.2f} ulp)", operation.name, operation.differing,
                                operation.worst_ulp);
    return text;
}

}  // namespace talus::claims
