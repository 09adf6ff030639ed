#pragma once
#include <cmath>
#include <glm/glm.hpp>

/// Lets the files of shaders/maths compile as C++ inside a class template:
///
///     template <typename Real>
///     struct ThermalTwin : TwinTypes<Real> {
///         TALUS_TWIN_NAMES(Real)
///         real4 load_solid(int2 at) const;
///     #include "maths/thermal.glsl"
///     };
///
/// Scalars in float round as llvmpipe does (law 4): `precise` there, -ffp-contract=off here.
#define precise

namespace talus::maths {

using std::abs;
using std::floor;
using std::sqrt;
template <typename T>
constexpr T min(T a, T b) {
    return b < a ? b : a;
}
template <typename T>
constexpr T max(T a, T b) {
    return a < b ? b : a;
}

}  // namespace talus::maths

#define TALUS_TWIN_NAMES(Real)       \
    using real = Real;               \
    using real2 = glm::vec<2, Real>; \
    using real3 = glm::vec<3, Real>; \
    using real4 = glm::vec<4, Real>; \
    using int2 = glm::ivec2;         \
    using uint = unsigned;
